#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/claimed_names.hpp>
#include <kanexpr/derivation/read/reading.hpp>
#include <kanexpr/derivation/read/symbol_uses.hpp>
#include <kanexpr/mechanics/checks/check_name.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the symbols of a model: listed ones in the order of the lists, all others in the order in which the
/// model mentions them.
class symbol_reader {
public:
  constexpr explicit symbol_reader(reading& all) : reading_(all), m_(all.into.mechanism) {}

  constexpr expression symbol(const symbol_record& r, std::string_view whom) {
    const expression found = known_symbol(r, whom);
    if (r.unit != nullptr) reading_.state_unit({found, *r.unit, r.is_unit_implied});
    return found;
  }

  /// The number of symbols of each kind that phrases may add.
  struct count {
    int parameters;
    int inputs;
    int prescribed_rates;
    int claimed;
  };
  constexpr count symbols_known() const {
    return {m_.parameters.size(), m_.inputs.size(), m_.prescribed_rates.size(), names_.size()};
  }
  constexpr void forget_all_but(const count& known) {
    while (m_.parameters.size() > known.parameters) m_.parameters.pop();
    while (m_.inputs.size() > known.inputs) m_.inputs.pop();
    while (m_.prescribed_rates.size() > known.prescribed_rates) m_.prescribed_rates.pop();
    names_.forget_all_but(known.claimed);
  }

  /// The known symbols, if there is no mistake.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.bound_, self.bound_values_, self.bound_is_used_, self.names_, self.is_time_claimed_);
  }

  /// Adds a parameter that the model itself does not mention, after all others.
  constexpr void add_parameter(const symbol_record& r) {
    if (!bound_.contains(r.called) && !has(m_.parameters, r.called)) m_.parameter(r.called);
  }

  constexpr const symbol_record* listed_symbol(const phrase& p, symbolic::symbol_kind kind,
                                               symbol_list list) {
    if (p.size != 1 || p.tokens[0].what != describe::token_kind::symbol) {
      reading_.fail({"the list of ", derivation::called(list), " contains something that is not a symbol",
                     p.size > 1 ? ", involving " : "", name_in(p)});
      return nullptr;
    }
    const symbol_record* s = p.tokens[0].symbol;
    const bool is_state_variable = s->order == describe::of_state_variable;
    if (s->kind != kind || is_state_variable != (list == symbol_list::state_variables)) {
      reading_.fail({kind_of(*s), s->called.view(), " is in the list of ", derivation::called(list)});
      return nullptr;
    }
    claim(*s, list);
    return s;
  }

  /// Adds a listed parameter.
  constexpr void place_parameter(const symbol_record& r) {
    used_parameters_.expect(m_.parameters.size());
    m_.parameter(r.called);
  }
  /// Adds a listed auxiliary speed.
  constexpr void place_auxiliary_speed(const symbol_record& r) {
    used_auxiliary_.expect(m_.auxiliary_speeds.size());
    m_.auxiliary_speed(r.called);
  }
  /// Adds a listed input.
  constexpr void place_listed_input(const symbol_record& r) {
    used_inputs_.expect(m_.inputs.size());
    place_input(r);
  }

  /// Adds an input. Links a prescribed quantity to its rate, in whichever order they appear.
  constexpr void place_input(const symbol_record& r) {
    const expression placed = m_.input(r.called);
    if (r.order == describe::unprescribed) return;
    const base::name rate = derivative(r, r.order + 1);
    if (has(m_.inputs, rate)) m_.prescribed_rates.push({placed, find(m_.inputs, rate)});
    if (r.order == 0) return;
    const base::name below = derivative(r, r.order - 1);
    if (has(m_.inputs, below)) m_.prescribed_rates.push({find(m_.inputs, below), placed});
  }

  /// Places all inputs added to a system without a list of inputs, unless they are already placed.
  constexpr void place_added_inputs() {
    const auto& added = reading_.from.added_inputs;
    if (added.size == 0 || are_added_inputs_placed()) return;
    for (int i = 0; i < added.size; ++i)
      if (const symbol_record* s = listed_symbol(added[i], symbolic::symbol_kind::input, symbol_list::inputs))
        place_listed_input(*s);
    for (int i = 0; i < added.size && !reading_.mistake; ++i) check_derivative(*added[i].tokens[0].symbol);
  }

  /// Reports a derivative that is listed without the quantity itself. Requires that the list of inputs was
  /// read.
  constexpr void check_derivative(const symbol_record& r) {
    if (r.order <= 0) return;
    const base::name below = derivative(r, r.order - 1);
    if (!has(m_.inputs, below))
      reading_.fail({"the list of inputs contains ", r.called.view(),
                     ", a derivative of a prescribed quantity, without ", below.view()});
  }

  /// Claims the name of a symbol, which must be valid.
  constexpr void claim(const symbol_record& r, symbol_list list) {
    if (r.is_named) return names_.claim(r.called, list, mark_of(r));
    std::string_view called = r.given == 0 ? "" : r.called.view();
    if (r.given < r.called.length && r.called.length == base::name::capacity)
      return reading_.fail(
          {"a name that begins with ", called.substr(0, 20), " is longer than 60 characters"});
    if (called.size() < base::name::capacity && r.order > 0)
      called.remove_suffix(static_cast<std::size_t>(r.order));
    reading_.fail({mechanics::check_name(called, derivation::called(list)).view()});
  }

  /// Claims a name, which must have only one meaning in a system.
  constexpr void claim_name(const base::name& called, symbol_list list) { names_.claim(called, list); }

  /// Binds a parameter to a number. If the model is read for its units, the parameter stays a symbol.
  constexpr void bind(const symbol_record& r, expression number) {
    reading_.hides_units = true;
    bound_.push(r.called);
    bound_values_.push(reading_.for_units ? symbolic::variable(*m_.g, {r.kind, r.called, none}) : number);
    bound_is_used_.push(0);
    claim(r, symbol_list::values);
  }
  constexpr bool is_bound(const base::name& called) const { return bound_.contains(called); }
  constexpr bool holds_bound(const phrase& p) const {
    for (int i = 0; i < p.size; ++i)
      if (p.tokens[i].symbol != nullptr && is_bound(p.tokens[i].symbol->called)) return true;
    return false;
  }
  /// Registers a parameter or an input that is needed only for results requested later.
  constexpr void mention_elsewhere(const phrase& p) {
    using symbolic::symbol_kind;
    constexpr std::string_view whom = "used_elsewhere<...>"sv;
    const bool alone = p.size == 1 && p.tokens[0].what == describe::token_kind::symbol;
    const symbol_record* s = alone ? p.tokens[0].symbol : nullptr;
    if (s == nullptr || (s->kind != symbol_kind::parameter && s->kind != symbol_kind::input))
      return reading_.fail({whom, " contains something that is neither a parameter nor an input",
                            name_in(p).empty() ? "" : ", involving ", name_in(p)});
    symbol(*s, whom);
  }

  /// Checks that every bound value is used. Requires that the whole model was read.
  constexpr void check_values_are_used() {
    for (int i = 0; i < bound_.size(); ++i)
      if (bound_is_used_[i] == 0)
        reading_.fail(
            {"values<...> binds parameter ", bound_[i].view(), ", which nothing in the system uses"});
  }
  /// Checks that every listed symbol is used.
  constexpr void check_listed_are_used() {
    for (int i = 0; i < used_parameters_.size(); ++i)
      if (!used_parameters_[i]) fail_by_unused("parameter", m_.parameters[i]);
    for (int i = 0; i < used_inputs_.size(); ++i)
      if (!used_inputs_[i] && !is_derivative_used(i)) fail_by_unused("input", m_.inputs[i]);
    for (int i = 0; i < used_auxiliary_.size(); ++i)
      if (!used_auxiliary_[i])
        reading_.fail({"auxiliary speed ", m_.g->symbol_at(m_.auxiliary_speeds[i].node()).called.view(),
                       " is listed, but nothing in the system uses it"});
  }

private:
  /// A number with a unit, which is a symbol if the model is read for its units.
  constexpr expression constant_of(const symbol_record& r) {
    if (reading_.for_units) return symbolic::variable(*m_.g, {r.kind, r.called, none});
    reading_.hides_units = true;
    return symbolic::constant(*m_.g, *r.value);
  }

  constexpr expression known_symbol(const symbol_record& r, std::string_view whom) {
    using symbolic::symbol_kind;
    switch (r.kind) {
    case symbol_kind::time: claim_time(); return m_.time;
    case symbol_kind::coordinate: return listed(m_.coordinates, m_.coordinates, r, "coordinate"sv, whom);
    case symbol_kind::coordinate_rate:
      if (reading_.takes_rates_as_speeds()) return listed(m_.coordinates, m_.speeds, r, "coordinate"sv, whom);
      return listed(m_.coordinates, m_.coordinate_rates, r, "coordinate"sv, whom);
    case symbol_kind::speed:
      if (r.order == describe::of_state_variable) return state_variable(m_.speeds, r, whom);
      if (reading_.takes_rates_as_speeds())
        reading_.fail({reading_.part, whom, " contains the speed ", r.called.view(),
                       "; the only speeds of a lagrange_system are the rates of its coordinates"});
      if (const expression found = find(m_.auxiliary_speeds, r.called); !found.is_zero()) {
        used_auxiliary_.mark(m_.auxiliary_speeds.find(found));
        return is_the_same(r, "auxiliary speed"sv), found;
      }
      return listed(m_.speeds, m_.speeds, r, "speed"sv, whom);
    case symbol_kind::speed_rate:
      if (r.order == describe::of_state_variable) return state_variable(m_.speed_rates, r, whom);
      if (r.order != describe::unprescribed) return second_derivative(r, whom);
      if (has(m_.auxiliary_speeds, r.called))
        reading_.fail({reading_.part, whom, " contains the rate of auxiliary speed ", r.called.view(),
                       ", which is zero at all times"});
      return listed(m_.speeds, m_.speed_rates, r, "speed"sv, whom);
    case symbol_kind::auxiliary_speed:
    case symbol_kind::multiplier:
    case symbol_kind::weight: break; // not available in models
    case symbol_kind::direction:
      if (reading_.is_on_surface)
        return symbolic::variable(*m_.g, {r.kind, r.called, r.called.view().back() - 'x'});
      reading_.fail({reading_.part, whom, " contains ", r.called.view(),
                     ", which is valid only in point_on_surface<...> and uneven_ground<...>"});
      break;
    case symbol_kind::parameter:
      if (r.value != nullptr) return constant_of(r);
      for (int i = 0; i < bound_.size(); ++i)
        if (bound_[i] == r.called) {
          bound_is_used_[i] = 1;
          return is_the_same(r, "parameter"sv), bound_values_[i];
        }
      return mentioned(m_.parameters, used_parameters_, r, reading_.from.parameters.size != 0, "parameter"sv,
                       whom);
    case symbol_kind::input:
      place_added_inputs(r, whom);
      if (reading_.from.inputs.size == 0 && r.order != describe::unprescribed) place_with_derivatives(r);
      return mentioned(m_.inputs, used_inputs_, r, reading_.from.inputs.size != 0, "input", whom);
    }
    return m_.zero();
  }

  constexpr void fail_by_unused(std::string_view kind, const expression& symbol) {
    const std::string_view called = m_.g->symbol_at(symbol.node()).called.view();
    reading_.fail({kind, " ", called,
                   " is listed, but nothing in the system uses it; if this is intended, write ",
                   "used_elsewhere<", called, ">"});
  }

  /// Whether a derivative of a prescribed quantity is used; the quantity is listed with its derivatives, and
  /// a model may use any of them.
  constexpr bool is_derivative_used(int input) const {
    for (const bool upwards : {true, false}) {
      expression at = m_.inputs[input];
      for (bool is_any = true; is_any;) {
        is_any = false;
        for (const mechanics::prescribed_rate& p : m_.prescribed_rates) {
          if (!((upwards ? p.quantity : p.rate) == at)) continue;
          at = upwards ? p.rate : p.quantity;
          is_any = true;
          if (used_inputs_[m_.inputs.find(at)]) return true;
          break;
        }
      }
    }
    return false;
  }

  constexpr bool are_added_inputs_placed() const {
    const auto& added = reading_.from.added_inputs;
    const symbol_record* first = added.size == 0 || added[0].size == 0 ? nullptr : added[0].tokens[0].symbol;
    return first != nullptr && has(m_.inputs, first->called);
  }

  /// Called before an input is looked up. The first mention of an added input places all of them; an input
  /// that is first mentioned later would not be in any list.
  constexpr void place_added_inputs(const symbol_record& r, std::string_view whom) {
    const auto& added = reading_.from.added_inputs;
    if (added.size == 0 || has(m_.inputs, r.called)) return;
    for (int i = 0; i < added.size; ++i)
      if (added[i].size == 1 && added[i].tokens[0].symbol != nullptr &&
          added[i].tokens[0].symbol->called == r.called)
        return place_added_inputs();
    if (are_added_inputs_placed())
      reading_.fail({"input ", r.called.view(), ", which ", reading_.part, whom,
                     " contains, comes after those that extended<...> adds; list it in inputs<...>"});
  }

  constexpr bool has(const sequence<expression>& symbols, const base::name& called) const {
    return !find(symbols, called).is_zero();
  }
  /// Returns the symbol with the given name, or zero if there is none.
  constexpr expression find(const sequence<expression>& symbols, const base::name& called) const {
    for (const expression& e : symbols)
      if (m_.g->symbol_at(e.node()).called == called) return e;
    return m_.zero();
  }

  /// The second derivative of a coordinate, which exists only if its rate is a speed.
  constexpr expression second_derivative(const symbol_record& r, std::string_view whom) {
    if (reading_.takes_rates_as_speeds())
      return listed(m_.coordinates, m_.speed_rates,
                    {r.kind, derivative(r, 0), describe::unprescribed, r.given, r.is_named}, "coordinate"sv,
                    whom);
    reading_.fail({reading_.part, whom, " contains the second derivative of coordinate ",
                   derivative(r, 0).view(), "; write it in terms of the rates of the speeds"});
    return m_.zero();
  }

  /// Returns the name of a derivative, by its order: theta, theta', theta''.
  static constexpr base::name derivative(const symbol_record& r, int order) {
    const std::string_view own = r.called.view();
    base::name called = own.substr(0, own.size() - static_cast<std::size_t>(r.order));
    for (int i = 0; i < order; ++i) called.append("'");
    return called;
  }

  /// Without a list of inputs, a prescribed quantity occupies three consecutive places, because an
  /// acceleration needs its second derivative.
  constexpr void place_with_derivatives(const symbol_record& r) {
    for (int order = 0; order <= 2 || order <= r.order; ++order) {
      const symbol_record one{r.kind, derivative(r, order), order, r.given, r.is_named};
      if (has(m_.inputs, one.called)) continue;
      claim(one, symbol_list::inputs);
      place_input(one);
    }
  }

  /// A state variable or its rate; `wanted` are the speeds or their rates.
  constexpr expression state_variable(const sequence<expression>& wanted, const symbol_record& r,
                                      std::string_view whom) {
    for (int i = m_.speeds_of_motion(); i < m_.speeds.size(); ++i)
      if (mechanics::called(m_, m_.speeds[i]) == r.called.view())
        return is_the_same(r, "state variable"), wanted[i];
    reading_.fail({"state variable ", r.called.view(), ", which ", reading_.part, whom,
                   " contains, is not in states<...> or in a listed block"});
    return m_.zero();
  }

  constexpr expression listed(const sequence<expression>& own, const sequence<expression>& wanted,
                              const symbol_record& r, std::string_view kind, std::string_view whom) {
    for (int i = 0; i < own.size(); ++i)
      if (m_.g->symbol_at(own[i].node()).called == r.called) return is_the_same(r, kind), wanted[i];
    return fail_by_unlisted(r, kind, whom);
  }
  constexpr expression fail_by_unlisted(const symbol_record& r, std::string_view kind,
                                        std::string_view whom) {
    reading_.fail({kind, " ", r.called.view(), ", which ", reading_.part, whom,
                   " contains, is not in the list of ", kind, "s"});
    return m_.zero();
  }

  constexpr expression mentioned(const sequence<expression>& known, symbol_uses& used, const symbol_record& r,
                                 bool complete, std::string_view kind, std::string_view whom) {
    for (int i = 0; i < known.size(); ++i)
      if (m_.g->symbol_at(known[i].node()).called == r.called) {
        used.mark(i);
        return is_the_same(r, kind), known[i];
      }
    if (complete) return fail_by_unlisted(r, kind, whom);
    claim(r, r.kind == symbolic::symbol_kind::input ? symbol_list::inputs : symbol_list::parameters);
    return r.kind == symbolic::symbol_kind::input ? m_.input(r.called) : m_.parameter(r.called);
  }

  /// Distinguishes symbols of the same kind and name: `parameter<"k", 1>` and `parameter<"k1">`, or an input
  /// and a prescribed quantity.
  static constexpr int mark_of(const symbol_record& r) {
    const bool is_prescribed = r.kind == symbolic::symbol_kind::input && r.order != describe::unprescribed;
    const bool is_special = is_prescribed || r.order == describe::of_state_variable;
    return 2 * r.given + (is_special ? 1 : 0);
  }

  /// Checks that a symbol found by its name is the one that claimed the name.
  constexpr void is_the_same(const symbol_record& r, std::string_view kind) {
    names_.check_mark(r.called, mark_of(r), kind);
  }

  constexpr void claim_time() {
    if (!is_time_claimed_) claim_name("t", symbol_list::times);
    is_time_claimed_ = true;
  }

  reading& reading_;
  mechanism& m_;
  sequence<base::name> bound_{};
  sequence<expression> bound_values_{};
  sequence<char> bound_is_used_{};
  claimed_names names_{reading_};
  symbol_uses used_parameters_{}, used_inputs_{}, used_auxiliary_{}; ///< unused after a model has been read
  bool is_time_claimed_ = false;
};

} // namespace kanexpr::derivation
