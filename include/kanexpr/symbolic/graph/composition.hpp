#pragma once

namespace kanexpr::symbolic {

/// A function that has a name in models and is written in terms of others in the graph (compose.hpp).
enum class composition : unsigned char {
  hypot,
  if_positive,
  min,
  max,
  clamp,
  smooth_abs,
  softplus,
  smooth_step,
  tabulated,
  periodic,
};

inline constexpr int variadic = -1;

/// The name of a composition in models and its number of operands.
struct composite_signature {
  composition is;
  const char* name;
  int operands;
};

/// Listed in the order of the enumeration; a test checks this.
inline constexpr composite_signature compositions[] = {
    {composition::hypot, "hypot", 2},
    {composition::if_positive, "if_positive", 3},
    {composition::min, "min", 2},
    {composition::max, "max", 2},
    {composition::clamp, "clamp", 3},
    {composition::smooth_abs, "smooth_abs", 2},
    {composition::softplus, "softplus", 2},
    {composition::smooth_step, "smooth_step", 3},
    {composition::tabulated, "tabulated", variadic},
    {composition::periodic, "periodic", variadic},
};

constexpr const composite_signature& signature_of(composition f) { return compositions[static_cast<int>(f)]; }

} // namespace kanexpr::symbolic
