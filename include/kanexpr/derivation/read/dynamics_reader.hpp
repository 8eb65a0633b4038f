#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/describe/symbol.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the equations for the rates of the state variables. Each belongs to the state variable whose rate it
/// contains first. Equations that depend on motion are evaluated once velocities are known.
class dynamics_reader : part_reader {
  /// The list to which an equation belongs, for messages.
  struct source {
    sentence called{};
    bool is_block = false;

    constexpr source(const sentence& name, bool block = false) : called(name), is_block(block) {}
    constexpr source(std::string_view name) : called({name}) {}
    constexpr std::string_view whom() const { return called.view(); }
  };

  // precedes its callers, because clang++ does not instantiate a template for a constant expression if it is
  // declared later in the class
  template <class Visit>
  constexpr void each_listing(const Visit& visit) const {
    visit(reading_.from.dynamics, source{"an equation of dynamics<...>"sv});
    for (const describe::block_record& r : reading_.from.blocks)
      visit(r.dynamics, source{sentence({"block ", r.called}), true});
    for (const describe::load_record& r : reading_.from.loads)
      if (r.dynamics.size != 0) visit(r.dynamics, source{name_of(r)});
  }

public:
  using part_reader::part_reader;

  /// Reports an entry of `blocks<…>` that is not a block, is listed twice or has the wrong number of
  /// arguments.
  constexpr void check_blocks() {
    const describe::listing<describe::block_record>& all = reading_.from.blocks;
    for (int i = 0; i < all.size; ++i) {
      const describe::block_record& r = all[i];
      if (r.unparsed) return reading_.fail_by_unparsed(r.called, "blocks<...>");
      if (!r.instead.empty())
        return reading_.fail({"blocks<...> lists ", short_name(r.called).view(), ", which is ", r.instead});
      if (!r.fits) return reading_.fail_by_argument_count("block ", r.called, r.fits);
      for (int j = 0; j < i; ++j)
        if (&all[j] == &r) return reading_.fail({"block ", r.called, " is listed twice"});
    }
  }

  constexpr void read() {
    each_listing([&](const describe::listing<phrase>& equations, const source& from) {
      for (const phrase& p : equations)
        if (!reading_.mistake) read(p, from);
    });
    for (const describe::block_record& r : reading_.from.blocks)
      read_positive(r.positive, sentence({"block ", r.called}));
    for (const describe::load_record& r : reading_.from.loads)
      if (r.positive.size != 0) read_positive(r.positive, name_of(r));
  }

  /// Reads the equations that depend on motion; returns whether there are any. Requires that
  /// `set_known_motion` was called.
  constexpr bool read_moving() {
    bool is_any = false;
    each_listing([&](const describe::listing<phrase>& equations, const source& from) {
      for (const phrase& p : equations) {
        if (reading_.mistake || !moves(p)) continue;
        is_any = true;
        evaluate(p, from);
      }
    });
    return is_any;
  }

private:
  constexpr void read(const phrase& p, const source& from) {
    if (p.kind != shape::equation)
      return reading_.fail({"dynamics<...> contains something that is not an equation",
                            name_in(p).empty() ? "" : ", involving ", name_in(p), "; write dot(z) == rate"});
    if (state_variable_of(p) == nullptr) return fail_without_rate(p, from.whom());
    if (!moves(p)) return evaluate(p, from);
    phrases_.check_misuse(p, from.whom());
    mention(p, from.whom());
  }

  /// Reads arguments that must be positive, after the dynamics, in which all of them appear.
  constexpr void read_positive(const describe::listing<describe::positive_argument>& all,
                               const sentence& whose) {
    for (const describe::positive_argument& each : all) {
      if (reading_.mistake) return;
      if (moves(each.value)) continue;
      const expression value = phrases_.scalar_of(each.value, {each.of, whose.view()}, whose.view());
      base::name of = each.of;
      of.append(whose.view());
      if (!reading_.mistake) reading_.into.loads.positive_constants.push({value, of});
    }
  }

  constexpr bool moves(const phrase& p) const {
    for (const describe::token& t : p)
      if (!phrases_.is_declared(t)) return true;
    return false;
  }

  /// The first rate of a state variable in an equation, or null.
  static constexpr const symbol_record* state_variable_of(const phrase& p) {
    for (const describe::token& t : p)
      if (t.symbol != nullptr && t.symbol->kind == symbolic::symbol_kind::speed_rate &&
          t.symbol->order == describe::of_state_variable)
        return t.symbol;
    return nullptr;
  }

  constexpr void fail_without_rate(const phrase& p, std::string_view whom) {
    using symbolic::symbol_kind;
    for (const describe::token& t : p)
      if (t.symbol != nullptr &&
          (t.symbol->kind == symbol_kind::speed_rate || t.symbol->kind == symbol_kind::coordinate_rate))
        return reading_.fail({whom, " contains ", kind_of(*t.symbol), t.symbol->called.view(),
                              ", but the rate of no state variable; declare it as state_variable<...>"});
    reading_.fail({whom, name_in(p).empty() ? "" : " with ", name_in(p),
                   " contains the rate of no state variable; write dot(z) == rate"});
  }

  /// Whether the rate is multiplied by a negative number on the left side, on which it is in all blocks.
  static constexpr bool has_negative_factor(expression equation, expression rate) {
    const expression factor = symbolic::differentiate(equation, rate);
    return factor.is_constant() && factor.owner().number_at(factor.node()).value() < 0;
  }

  constexpr void evaluate(const phrase& p, const source& from) {
    const std::string_view whom = from.whom();
    const value left_minus_right = phrases_.evaluate(p, whom);
    if (!reading_.mistake && left_minus_right.kind != shape::scalar)
      reading_.fail(
          {whom, " with ", name_in(p), " equates vectors; equate their dot products with basis vectors"});
    const expression rate = symbols_.symbol(*state_variable_of(p), whom);
    if (reading_.mistake) return;
    const mechanics::solved_state_rate solved =
        mechanics::solve_for_state_rate(m_, m_.speed_rates.find(rate), left_minus_right.scalar);
    reading_.mistake = solved.mistake;
    if (from.is_block && has_negative_factor(left_minus_right.scalar, rate))
      return reading_.fail({whom, " multiplies the rate of state variable ",
                            state_variable_of(p)->called.view(),
                            " by a negative number; a time constant must be positive"});
    if (!reading_.mistake) reading_.into.loads.state_rates.push(solved.found);
  }
};

} // namespace kanexpr::derivation
