#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <Eigen/Core>

#include <cmath>

namespace kanexpr::numeric {

/// Powers of two that scale the rows and columns of a matrix so that the largest entry of each is near 1.
/// Pivots can then be compared regardless of the units of equations and unknowns.
template <class Vector>
struct equilibration {
  using number = typename Vector::Scalar;
  Vector rows, columns;

  template <class Matrix>
  explicit equilibration(const Matrix& a) : rows(Vector::Ones(a.rows())), columns(Vector::Ones(a.cols())) {
    for (int sweeps = 0; sweeps < 3; ++sweeps) {
      for (Eigen::Index i = 0; i < a.rows(); ++i) {
        number most = 0;
        for (Eigen::Index j = 0; j < a.cols(); ++j) most = (std::max)(most, std::abs(a(i, j)) * columns(j));
        rows(i) = inverse(most);
      }
      for (Eigen::Index j = 0; j < a.cols(); ++j) {
        number most = 0;
        for (Eigen::Index i = 0; i < a.rows(); ++i) most = (std::max)(most, std::abs(a(i, j)) * rows(i));
        columns(j) = inverse(most);
      }
    }
  }

  template <class Matrix>
  Matrix applied_to(const Matrix& a) const {
    return rows.asDiagonal() * a * columns.asDiagonal();
  }

private:
  static number inverse(number size) {
    return size > 0 && is_finite(size) ? std::ldexp(number(1), -std::ilogb(size)) : 1;
  }
};

} // namespace kanexpr::numeric
