#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/numeric/elementary.hpp>

/// User-defined functions in models.
namespace kanexpr::symbolic {

/// The highest order of derivatives of a user-defined function, and its maximum number of operands.
inline constexpr int max_derivatives = 4, max_operands = 9;

/// A user-defined function in an expression: its name and its partial derivatives, each of which is itself
/// such a function. Functions are identified by their addresses.
struct external_function {
  base::name called{};   ///< `tyre`; `tyre_1_2` for its derivative with respect to operands 1 and 2
  base::name original{}; ///< `tyre`
  int operands = 0;      ///< number of operands
  int order = 0;         ///< order of the derivative
  int by[max_derivatives]{};
  /// Evaluates the function; null if the program does not provide this derivative.
  double (*value)(const double*) = nullptr;
  /// The derivatives with respect to each operand; null if they are never needed.
  const external_function* const* slopes = nullptr;

  constexpr bool is_provided() const { return value != nullptr; }
  /// Returns a derivative. If a function is not provided, neither are its derivatives.
  constexpr const external_function& slope(int operand) const {
    return slopes == nullptr ? *this : *slopes[operand];
  }
};

/// A substitute value for tests of expressions at generic points, because the compiler may be unable to call
/// the function: 1.25 plus a sine of the operands, with matching derivatives.
constexpr double substitute_value(const external_function& f, const double* operands) {
  unsigned mark = 2166136261u; // the FNV hash of Fowler, Noll & Vo
  for (char letter : f.original.view()) mark = (mark ^ static_cast<unsigned char>(letter)) * 16777619u;
  const auto between = [](unsigned bits) { return static_cast<double>(bits >> 8) / 16777216.0; };
  double weights[1 + max_derivatives]{}, phase = 1.5 * between(mark), factor = 1;
  for (int i = 0; i < f.operands; ++i) {
    mark = mark * 1664525u + 1013904223u;
    const double weight = 0.4 + 0.4 * between(mark);
    phase += weight * operands[i];
    for (int k = 0; k < f.order; ++k)
      if (f.by[k] == i) weights[k] = weight;
  }
  for (int k = 0; k < f.order; ++k) factor *= weights[k];
  switch (f.order % 4) {
  case 0: return (f.order == 0 ? 1.25 : 0) + factor * numeric::elementary::sin(phase);
  case 1: return factor * numeric::elementary::cos(phase);
  case 2: return -(factor * numeric::elementary::sin(phase));
  default: return -(factor * numeric::elementary::cos(phase));
  }
}

#pragma GCC diagnostic push
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wnon-template-friend"
#endif
/// Maps a function to the type that calls it with any scalar type, `decltype(callable_of(key))`.
template <const external_function* function>
struct external_key {
  friend constexpr auto callable_of(external_key);
};
#pragma GCC diagnostic pop

/// Defines the type that calls the function when it is instantiated.
template <class Code, const external_function* function>
struct external_registration {
  friend constexpr auto callable_of(external_key<function>) { return Code{}; }
};

} // namespace kanexpr::symbolic
