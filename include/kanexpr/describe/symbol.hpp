#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

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

template <symbolic::symbol_kind represented, text called, int index, int order = unprescribed>
struct symbol : scalar<1> {
  constexpr symbol() : scalar<1>(symbol_token<represented, called, index, order>()) {}

  template <class Right>
  constexpr auto operator=(const Right& other) const {
    return misused<shape::equation>(misuse::assignment, *this, other);
  }
};

} // namespace describe

/// A generalized coordinate: `constexpr coordinate<"q1"> q1;`, or one of a numbered sequence,
/// `coordinate<"q", i>`.
template <text called, int index = unnumbered>
using coordinate = describe::symbol<symbolic::symbol_kind::coordinate, called, index>;

/// A generalized speed.
template <text called, int index = unnumbered>
using speed = describe::symbol<symbolic::symbol_kind::speed, called, index>;

/// A constant of the system, passed to each evaluation or bound in the type by `values`.
template <text called, int index = unnumbered>
using parameter = describe::symbol<symbolic::symbol_kind::parameter, called, index>;

/// A force, torque or other quantity that is passed to each evaluation and may vary arbitrarily.
template <text called, int index = unnumbered>
using input = describe::symbol<symbolic::symbol_kind::input, called, index>;

/// A quantity that is a known function of time: `constexpr prescribed<"theta"> theta;` Its value and its
/// derivatives `dot(theta)` and `dot(dot(theta))` are passed to each evaluation as inputs.
template <text called, int index = unnumbered, int order = 0>
using prescribed = describe::symbol<symbolic::symbol_kind::input, called, index, order>;

/// The time, for explicitly time-dependent expressions.
using time_variable = describe::symbol<symbolic::symbol_kind::time, "t", unnumbered>;

/// The rate dq/dt of a coordinate, `dot(q)`.
template <text called, int index = unnumbered>
using coordinate_rate = describe::symbol<symbolic::symbol_kind::coordinate_rate, called, index>;

template <text called, int index>
constexpr coordinate_rate<called, index> dot(const coordinate<called, index>&) {
  return {};
}

/// The second derivative of a coordinate, for systems in which its rate replaces a speed.
template <text called, int index>
constexpr scalar<1> dot(const coordinate_rate<called, index>&) {
  return describe::symbol_token<symbolic::symbol_kind::speed_rate, called, index, 1>();
}

/// The derivative of a prescribed quantity.
template <text called, int index, int order>
  requires(order != describe::unprescribed)
constexpr prescribed<called, index, order + 1> dot(const prescribed<called, index, order>&) {
  return {};
}

/// The rate du/dt of a speed.
template <text called, int index>
constexpr scalar<1> dot(const speed<called, index>&) {
  return describe::symbol_token<symbolic::symbol_kind::speed_rate, called, index>();
}

} // namespace kanexpr
