#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <Eigen/Core>

namespace kanexpr::numeric {

/// Whether all entries are finite. Tests their bits and therefore works with -ffast-math.
template <class Derived>
bool all_finite(const Eigen::DenseBase<Derived>& m) {
  for (Eigen::Index j = 0; j < m.cols(); ++j)
    for (Eigen::Index i = 0; i < m.rows(); ++i)
      if (!is_finite(m.derived().coeff(i, j))) return false;
  return true;
}

/// Returns the largest magnitude of an entry, or NaN if an entry is not finite.
template <class Vector>
double largest(const Vector& v) {
  if (!all_finite(v)) return not_a_number<double>; // a maximum does not always propagate NaN
  return v.size() == 0 ? 0.0 : static_cast<double>(v.cwiseAbs().maxCoeff());
}

} // namespace kanexpr::numeric
