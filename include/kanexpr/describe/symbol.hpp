#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/decimal_text.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>
#include <kanexpr/units/unit.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <concepts>
#include <type_traits>

namespace kanexpr {

/// @internal Denotes "no index" in `coordinate<"q">`.
inline constexpr int unnumbered = -1;

namespace describe {

template <symbolic::symbol_kind kind, text called, int index, int order = unprescribed>
struct symbol_storage {
  static constexpr symbol_record record = [] {
    symbol_record r{kind, base::name(called.view()), order, static_cast<int>(called.view().size())};
    if (index != unnumbered) r.called.append(index);
    r.is_named = called.view().size() != 0 && symbolic::is_name(r.called.view());
    for (int i = 0; i < order; ++i) r.called.append("'");
    if (r.called.length == base::name::capacity) r.is_named = false; // it may be truncated
    return r;
  }();
};

template <symbolic::symbol_kind kind, text called, int index, int order = unprescribed>
constexpr scalar<1> symbol_token() {
  token t{};
  t.what = token_kind::symbol;
  t.symbol = &symbol_storage<kind, called, index, order>::record;
  return {{t}};
}

/// The unit of a symbol or a constant.
constexpr const units::unit& unit_in(const units::unit& stated) { return stated; }
constexpr const units::unit& unit_in(const units::implied_unit& implied) { return implied.of; }

template <auto stated>
inline constexpr bool is_implied = std::same_as<std::remove_cv_t<decltype(stated)>, units::implied_unit>;

template <auto stated>
concept stated_unit = is_implied<stated> || std::same_as<std::remove_cv_t<decltype(stated)>, units::unit>;

/// A symbol of a model; `stated` is its unit, if the model states or implies one.
template <symbolic::symbol_kind represented, text called, int index, int order = unprescribed, auto... stated>
struct symbol;

template <symbolic::symbol_kind represented, text called, int index, int order>
struct symbol<represented, called, index, order> : scalar<1> {
  constexpr symbol() : scalar<1>(symbol_token<represented, called, index, order>()) {}

  template <class Right>
  constexpr auto operator=(const Right& other) const {
    return misused<shape::equation>(misuse::assignment, *this, other);
  }
};

/// It is derived from the same symbol without a unit, so that both have the same rate and the same place in a
/// vector of values.
template <symbolic::symbol_kind represented, text called, int index, int order, auto stated>
struct symbol<represented, called, index, order, stated> : symbol<represented, called, index, order> {
  using without_unit = symbol<represented, called, index, order>;

  static constexpr units::unit stated_unit = unit_in(stated);
  static constexpr symbol_record record = [] {
    symbol_record r = symbol_storage<represented, called, index, order>::record;
    r.unit = &stated_unit, r.is_unit_implied = is_implied<stated>;
    return r;
  }();

  constexpr symbol() { this->tokens[0].symbol = &record; }
  using without_unit::operator=;
};

/// A constant with a unit, as a symbol that denotes a number.
template <auto value, auto stated>
struct constant_storage {
  static constexpr symbolic::number number = constant(value).tokens[0].number;
  static constexpr units::unit unit = unit_in(stated);
  static constexpr symbol_record record = [] {
    symbol_record r{symbolic::symbol_kind::parameter, symbolic::decimal_text(number)};
    r.called.append(" "), r.called.append(units::text_of(unit, units::spelling::message).view());
    r.unit = &unit, r.value = &number, r.is_unit_implied = is_implied<stated>;
    return r;
  }();
};

/// The symbol with the given index, unit, both or neither.
template <symbolic::symbol_kind represented, text called, int order, auto... index_and_unit>
struct symbol_with {
  static_assert(sizeof...(index_and_unit) == 0,
                "after its name, a symbol takes an integer, a unit, or an integer and a unit");
  using type = symbol<represented, called, unnumbered, order>;
};
template <symbolic::symbol_kind represented, text called, int order, auto index>
  requires std::convertible_to<decltype(index), int>
struct symbol_with<represented, called, order, index> {
  using type = symbol<represented, called, static_cast<int>(index), order>;
};
template <symbolic::symbol_kind represented, text called, int order, auto stated>
  requires stated_unit<stated>
struct symbol_with<represented, called, order, stated> {
  using type = symbol<represented, called, unnumbered, order, stated>;
};
template <symbolic::symbol_kind represented, text called, int order, auto index, auto stated>
  requires(std::convertible_to<decltype(index), int> && stated_unit<stated>)
struct symbol_with<represented, called, order, index, stated> {
  using type = symbol<represented, called, static_cast<int>(index), order, stated>;
};

} // namespace describe

/// A generalized coordinate: `constexpr coordinate<"q1"> q1;`, or one of a numbered sequence,
/// `coordinate<"q", i>`. Every symbol may also state its unit, last: `coordinate<"q1", radian>`.
template <text called, auto... index_and_unit>
using coordinate = typename describe::symbol_with<symbolic::symbol_kind::coordinate, called,
                                                  describe::unprescribed, index_and_unit...>::type;

/// A generalized speed.
template <text called, auto... index_and_unit>
using speed = typename describe::symbol_with<symbolic::symbol_kind::speed, called, describe::unprescribed,
                                             index_and_unit...>::type;

/// A state variable: a scalar that is neither a coordinate nor a speed, such as the current of a motor or the
/// memory of a filter. `dynamics` gives its rate, `dot(z)`.
template <text called, auto... index_and_unit>
using state_variable = typename describe::symbol_with<symbolic::symbol_kind::speed, called,
                                                      describe::of_state_variable, index_and_unit...>::type;

/// A constant of the system, passed to each evaluation or bound in the type by `values`.
template <text called, auto... index_and_unit>
using parameter = typename describe::symbol_with<symbolic::symbol_kind::parameter, called,
                                                 describe::unprescribed, index_and_unit...>::type;

/// A force, torque or other quantity that is passed to each evaluation and may vary arbitrarily.
template <text called, auto... index_and_unit>
using input = typename describe::symbol_with<symbolic::symbol_kind::input, called, describe::unprescribed,
                                             index_and_unit...>::type;

/// A quantity that is a known function of time: `constexpr prescribed<"theta"> theta;` Its value and its
/// derivatives `dot(theta)` and `dot(dot(theta))` are passed to each evaluation as inputs.
template <text called, auto... index_and_unit>
using prescribed =
    typename describe::symbol_with<symbolic::symbol_kind::input, called, 0, index_and_unit...>::type;

/// A number with a unit: `constant<9.81, meter/pow<2>(second)>`. A plain number has no unit if it is a
/// factor.
template <auto value, auto u>
  requires(describe::plain_number<decltype(value)> && describe::stated_unit<u>)
inline constexpr scalar<1> constant = [] {
  describe::token t{};
  t.what = describe::token_kind::symbol;
  t.symbol = &describe::constant_storage<value, u>::record;
  return scalar<1>{{t}};
}();

/// The time, for explicitly time-dependent expressions.
using time_variable = describe::symbol<symbolic::symbol_kind::time, "t", unnumbered>;

/// The rate dq/dt of a coordinate, `dot(q)`.
template <text called, int index = unnumbered>
using coordinate_rate = describe::symbol<symbolic::symbol_kind::coordinate_rate, called, index>;

template <text called, int index, auto... stated>
constexpr coordinate_rate<called, index>
dot(const describe::symbol<symbolic::symbol_kind::coordinate, called, index, describe::unprescribed,
                           stated...>&) {
  return {};
}

/// The second derivative of a coordinate, for systems in which its rate replaces a speed.
template <text called, int index>
constexpr scalar<1> dot(const coordinate_rate<called, index>&) {
  return describe::symbol_token<symbolic::symbol_kind::speed_rate, called, index, 1>();
}

/// The derivative of a prescribed quantity.
template <text called, int index, int order, auto... stated>
  requires(order != describe::unprescribed)
constexpr describe::symbol<symbolic::symbol_kind::input, called, index, order + 1>
dot(const describe::symbol<symbolic::symbol_kind::input, called, index, order, stated...>&) {
  return {};
}

/// The rate du/dt of a speed.
template <text called, int index, auto... stated>
constexpr scalar<1>
dot(const describe::symbol<symbolic::symbol_kind::speed, called, index, describe::unprescribed, stated...>&) {
  return describe::symbol_token<symbolic::symbol_kind::speed_rate, called, index>();
}

/// The rate dz/dt of a state variable.
template <text called, int index, units::unit... stated>
constexpr scalar<1> dot(const describe::symbol<symbolic::symbol_kind::speed, called, index,
                                               describe::of_state_variable, stated...>&) {
  return describe::symbol_token<symbolic::symbol_kind::speed_rate, called, index,
                                describe::of_state_variable>();
}

} // namespace kanexpr
