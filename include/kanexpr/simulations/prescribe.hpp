#pragma once

#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <boost/math/differentiation/autodiff.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace kanexpr {

/// Sets the inputs for a prescribed quantity and its derivatives from a function of time, which is
/// differentiated exactly: `prescribe(r, theta, t, [](auto t) { using std::sin; return 0.1 * sin(t); })`.
template <class System, text called, int index, class Function>
void prescribe(input_values<System>& r,
               const describe::symbol<symbolic::symbol_kind::input, called, index, 0>& quantity, double t,
               const Function& f) {
  constexpr const derivation::survey& known = compiled::survey_of<System>;
  constexpr auto place = [](const describe::symbol_record& s) {
    return known.place(symbolic::symbol_kind::input, s.called);
  };
  const auto value = f(boost::math::differentiation::make_fvar<double, 2>(t));
  r[quantity] = value.derivative(0);
  constexpr int first =
      place(describe::symbol_storage<symbolic::symbol_kind::input, called, index, 1>::record);
  constexpr int second =
      place(describe::symbol_storage<symbolic::symbol_kind::input, called, index, 2>::record);
  if constexpr (first >= 0) r(first) = value.derivative(1);
  if constexpr (second >= 0) r(second) = value.derivative(2);
}

/// The same by name, for a run-time model: `prescribe(r, "theta", t, …)`.
template <class Inputs, class Function>
  requires requires(const Inputs& r, std::string_view name) { r.holds(name); }
void prescribe(Inputs& r, std::string_view quantity, double t, const Function& f) {
  const auto value = f(boost::math::differentiation::make_fvar<double, 2>(t));
  std::string name(quantity);
  r[name] = value.derivative(0);
  for (std::size_t order = 1; order <= 2; ++order) {
    name += '\'';
    if (r.holds(name)) r[name] = value.derivative(order);
  }
}

} // namespace kanexpr
