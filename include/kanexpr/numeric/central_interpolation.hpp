#pragma once

/// Polynomial interpolation at the center of points that lie at equal distances before and after it, but not
/// near it.
namespace kanexpr::numeric::central_interpolation {

/// The distances of the points, in steps.
inline constexpr int strides[4]{2, 3, 4, 5};

/// Returns the weight of each of the two points at a distance, in the polynomial through all points.
template <class Number>
constexpr Number weight_of(int reach) {
  Number weight = Number(0.5);
  for (const int other : strides)
    if (other != reach)
      weight *= static_cast<Number>(other * other) / static_cast<Number>(other * other - reach * reach);
  return weight;
}

} // namespace kanexpr::numeric::central_interpolation
