#pragma once

#include <kanexpr/numeric/elimination.hpp>

#include <Eigen/Core>

#include <limits>

namespace kanexpr::numeric {

/// A square matrix, factorized by the same elimination to which the solves of the graph are lowered. It
/// compiles much faster than Eigen's factorizations and does not allocate if `Vector` has a fixed size.
template <class Vector>
class factorized {
  using number = typename Vector::Scalar;
  using math = constant_elimination_math;

public:
  template <class Matrix>
  explicit factorized(const Matrix& a) : order_(static_cast<int>(a.rows())), f_(factors{order_}.size()) {
    const factors place{order_};
    for (int i = 0; i < order_; ++i)
      for (int j = 0; j < order_; ++j) f_(place.at(i, j)) = a(i, j);
    largest_ = a.cwiseAbs().maxCoeff();
    factorize<math>(order_, f_.data());
  }

  /// Returns the smallest pivot relative to the largest entry.
  number singularity_measure() const { return f_(factors{order_}.least_pivot()) / largest_; }

  /// Whether the smallest pivot is dominated by rounding.
  bool is_singular() const {
    return !(singularity_measure() > static_cast<number>(order_) * std::numeric_limits<number>::epsilon());
  }

  /// Replaces b by the solution of A x = b.
  void solve(Vector& b) const { solve_factorized<math>(order_, f_.data(), b.data()); }

private:
  static constexpr int fixed = Vector::RowsAtCompileTime;
  static constexpr int capacity = fixed < 0 ? Eigen::Dynamic : factors{fixed < 0 ? 0 : fixed}.size();

  int order_;
  Eigen::Matrix<number, capacity, 1> f_;
  number largest_ = 0;
};

} // namespace kanexpr::numeric
