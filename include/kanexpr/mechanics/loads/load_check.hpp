#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/bounded_value.hpp>
#include <kanexpr/mechanics/loads/load_names.hpp>
#include <kanexpr/mechanics/model/check_contents.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The context in which a load is checked: the contents of expressions and the first mistake. Alternatively,
/// it only collects the bounded values, whose numbers may not be known yet.
class load_check : public load_names {
public:
  constexpr load_check(const mechanism& m, const contents& held) : load_names(m), m_(m), held_(&held) {}
  constexpr load_check(const mechanism& m, sequence<bounded_value>& into)
      : load_names(m), m_(m), bounded_(&into) {}

  constexpr const sentence& mistake() const { return found_; }

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!found_) found_ = sentence(pieces);
  }

  /// Checks an expression that may contain anything except rates of speeds. `of` and `whose` name it, as in
  /// "the force at " and "P". The rates of state variables are known before those of the speeds.
  constexpr void check_no_speed_rates(expression e, std::string_view of, std::string_view whose) {
    if (held_ == nullptr || !held_->holds(e, kind::speed_rate)) return;
    for (const int id : held_->symbols_in(e, {kind::speed_rate}))
      if (const symbolic::symbol& s = m_.g->symbol_at(id); s.position < m_.speeds_of_motion())
        fail({of, whose, " contains the ", symbol_called(m_, s.kind, s.called.view()).view()});
  }
  constexpr void check_no_speed_rates(const vector& v, std::string_view of, std::string_view whose) {
    v.each_entry([&](expression e) { check_no_speed_rates(e, of, whose); });
  }

  /// Checks an expression that may contain only coordinates, parameters, inputs and time.
  constexpr void check_no_rates(expression e, std::string_view of, std::string_view whose) {
    if (held_ != nullptr && !found_) found_ = mechanics::check_no_rates(m_, *held_, e, of, whose);
  }

  /// Checks a quantity that would contribute an additional force if it depended on coordinates.
  constexpr void check_constant(expression e, std::string_view of, std::string_view whose) {
    if (held_ != nullptr) fail_varying(symbol_in(m_, *held_, e, {kind::coordinate}), of, whose);
    check_constant_rates(e, of, whose);
  }
  constexpr void check_constant_rates(expression e, std::string_view of, std::string_view whose) {
    if (held_ == nullptr) return;
    fail_varying(symbol_in(m_, *held_, e,
                           {kind::auxiliary_speed, kind::coordinate_rate, kind::speed, kind::speed_rate}),
                 of, whose);
  }
  /// Reports a symbol that a quantity contains but must not contain; does nothing if `symbol` is empty.
  constexpr void fail_varying(const sentence& symbol, std::string_view of, std::string_view whose) {
    if (symbol)
      fail({of, whose, " contains the ", symbol.view(), "; it may contain only parameters, inputs and time"});
  }

  /// Checks a property of a shape, which would contribute a further velocity if it changed.
  constexpr void check_fixed(expression e, std::string_view of, std::string_view whose) {
    if (held_ == nullptr) return;
    const sentence symbol = symbol_in(m_, *held_, e,
                                      {kind::coordinate, kind::auxiliary_speed, kind::coordinate_rate,
                                       kind::speed, kind::speed_rate, kind::input, kind::time});
    if (symbol) fail({of, whose, " contains the ", symbol.view(), "; it may contain only parameters"});
  }
  /// Checks an expression whose rate acts; the rates of the inputs that it contains must be known.
  constexpr void check_prescribed(expression e, std::string_view of, std::string_view whose) {
    if (held_ == nullptr) return;
    if (const sentence found = mechanics::check_prescribed(m_, *held_, e, 1, of, whose)) fail({found.view()});
  }

  /// Reports a number that is not positive.
  constexpr void check_positive(expression e, std::string_view of, std::string_view whose) {
    if (bounded_ != nullptr) bounded_->push({e, of, true});
    if (e.is_constant() && !(e.owner().number_at(e.node()).value() > 0))
      fail({of, whose, " is not positive"});
  }
  /// Reports a negative number.
  constexpr void check_not_negative(expression e, std::string_view of, std::string_view whose) {
    if (bounded_ != nullptr) bounded_->push({e, of, false});
    if (e.is_constant() && !(e.owner().number_at(e.node()).value() >= 0)) fail({of, whose, " is negative"});
  }

private:
  using kind = symbolic::symbol_kind;

  const mechanism& m_;
  const contents* held_ = nullptr;
  sequence<bounded_value>* bounded_ = nullptr;
  sentence found_{};
};

} // namespace kanexpr::mechanics
