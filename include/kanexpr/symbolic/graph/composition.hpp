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

inline constexpr int any_number = -1;

/// The name of a composition in models and its number of operands.
struct composition_word {
  composition is;
  const char* name;
  int operands;
};

/// In the order of the enumeration; a test checks this.
inline constexpr composition_word compositions[] = {
    {composition::hypot, "hypot", 2},
    {composition::if_positive, "if_positive", 3},
    {composition::min, "min", 2},
    {composition::max, "max", 2},
    {composition::clamp, "clamp", 3},
    {composition::smooth_abs, "smooth_abs", 2},
    {composition::softplus, "softplus", 2},
    {composition::smooth_step, "smooth_step", 3},
    {composition::tabulated, "tabulated", any_number},
    {composition::periodic, "periodic", any_number},
};

constexpr const composition_word& word_of(composition f) { return compositions[static_cast<int>(f)]; }

} // namespace kanexpr::symbolic
