#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/symbol.hpp>
#include <kanexpr/describe/wheel_record.hpp>
#include <kanexpr/mechanics/loads/magic_formula_coefficients.hpp>
#include <kanexpr/mechanics/loads/tyre_model.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr {

namespace describe {

template <class Type>
inline constexpr bool is_symbol = false;
template <symbolic::symbol_kind kind, text called, int index, int order, auto... stated>
inline constexpr bool is_symbol<symbol<kind, called, index, order, stated...>> = true;

template <class Type>
concept symbol_of_a_model = is_symbol<Type>;

/// A coefficient of a tyre: a number, or a symbol such as a parameter.
struct tyre_coefficient {
  phrase symbol{}; ///< empty for a number
  double number = 0;
  bool is_given = false;

  constexpr tyre_coefficient() = default;
  template <plain_number Number>
  constexpr tyre_coefficient(Number value) : number(static_cast<double>(value)), is_given(true) {}
  template <symbol_of_a_model Symbol>
  constexpr tyre_coefficient(const Symbol&) : symbol(phrase_of<Symbol{}>), is_given(true) {}
};

/// A tyre. Values that it does not have are empty phrases.
struct tyre_record {
  const wheel_record* wheel = nullptr;
  mechanics::tyre_model model{};
  const mechanics::magic_formula_coefficients<tyre_coefficient>* formula = nullptr;
  phrase slip_stiffness{}, cornering_stiffness{}, camber_stiffness{}, trail{}, friction{};
  phrase load{}, stiffness{}, damping{}, width{};
  phrase standstill{}, effective_radius{}, forward_length{}, lateral_length{};
  phrase forward_deflection{}, lateral_deflection{};
  arguments fits{};
  std::string_view mistake{}; ///< the end of a sentence; empty if there is none
};

} // namespace describe

/// The coefficients of the Magic Formula for a model of types, each a number or a parameter: `inline
/// constexpr tyre_coefficients slick{.Fz0 = 4000, .R0 = 0.3, .pCx1 = 1.6, .pDx1 = mu};`
using tyre_coefficients = mechanics::magic_formula_coefficients<describe::tyre_coefficient>;

} // namespace kanexpr
