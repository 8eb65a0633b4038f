#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/numeric/elementary.hpp>

/// Functions that a program brings to its models.
namespace kanexpr::symbolic {

/// How often a function of a program may be differentiated, and of how many operands it may be.
inline constexpr int most_derivatives = 4, most_operands = 9;

/// What expressions know of a function of a program: what it is called, and its derivatives by its operands,
/// each of which is such a function too. They are told apart by their addresses.
struct external_function {
  name called{};    ///< `tyre`, and `tyre_1_2` of its derivative by the first operand and the second
  name original{};  ///< `tyre`
  int operands = 0; ///< how many
  int order = 0;    ///< of the derivative
  int by[most_derivatives]{};
  /// At numbers; null: the program gives a function, and not this derivative of it.
  double (*value)(const double*) = nullptr;
  /// The derivatives by each operand; null: nobody will ask for them.
  const external_function* const* slopes = nullptr;

  constexpr bool is_given() const { return value != nullptr; }
  /// What is not given has no derivative that is.
  constexpr const external_function& slope(int operand) const {
    return slopes == nullptr ? *this : *slopes[operand];
  }
};

/// A value in place of that of the function, which the compiler may be unable to call, where expressions are
/// looked at by numbers that nobody chose: those of a function with all its derivatives, 1.25 plus a sine of
/// the operands.
constexpr double generic_value_of(const external_function& f, const double* operands) {
  unsigned mark = 2166136261u; // Fowler, Noll & Vo's hash
  for (char letter : f.original.view()) mark = (mark ^ static_cast<unsigned char>(letter)) * 16777619u;
  const auto between = [](unsigned bits) { return static_cast<double>(bits >> 8) / 16777216.0; };
  double weights[1 + most_derivatives]{}, phase = 1.5 * between(mark), factor = 1;
  for (int i = 0; i < f.operands; ++i) {
    mark = mark * 1664525u + 1013904223u;
    const double weight = 0.4 + 0.4 * between(mark);
    phase += weight * operands[i];
    for (int k = 0; k < f.order; ++k)
      if (f.by[k] == i) weights[k] = weight;
  }
  for (int k = 0; k < f.order; ++k) factor *= weights[k];
  switch (f.order % 4) {
  case 0: return (f.order == 0 ? 1.25 : 0) + factor * elementary::sin(phase);
  case 1: return factor * elementary::cos(phase);
  case 2: return -(factor * elementary::sin(phase));
  default: return -(factor * elementary::cos(phase));
  }
}

#pragma GCC diagnostic push
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wnon-template-friend"
#endif
/// Leads from a function to the type that calls it with any type of scalars, `decltype(code_of(tag))`.
template <const external_function* function>
struct external_tag {
  friend constexpr auto code_of(external_tag);
};
#pragma GCC diagnostic pop

/// Says which type that is, where it is instantiated.
template <class Code, const external_function* function>
struct external_link {
  friend constexpr auto code_of(external_tag<function>) { return Code{}; }
};

} // namespace kanexpr::symbolic
