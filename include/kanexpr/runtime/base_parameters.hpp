#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/model.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

/// The base parameters of a system: as few combinations of the inertial parameters of its bodies as inverse
/// dynamics depends on, π_base = K π with Y π = Y_base π_base. They are what experiments can identify
/// (Gautier, Numerical Calculation of the Base Inertial Parameters of Robots, Journal of Robotic Systems 8,
/// 1991).
struct base_parameters {
  std::vector<Eigen::Index> columns{}; ///< those of Y that are Y_base
  Eigen::MatrixXd combination{};       ///< K
  std::vector<std::string> names{};    ///< "izz of Upper + 0.25*m of Lower"
  mechanics::sentence failure{};       ///< why they were not found

  explicit operator bool() const { return !failure; }
  std::string cause() const { return failure.cause(); }

  /// Y_base, of any Y.
  template <class Regressor>
  Eigen::MatrixXd columns_of(const Eigen::MatrixBase<Regressor>& y) const {
    Eigen::MatrixXd base(y.rows(), static_cast<Eigen::Index>(columns.size()));
    for (Eigen::Index j = 0; j < base.cols(); ++j) base.col(j) = y.col(columns[static_cast<std::size_t>(j)]);
    return base;
  }
};

struct base_parameter_options {
  /// Beside the lengths of columns: what is no longer counts as nothing.
  double tolerance = 1e-9;
  std::uint64_t seed = 1; ///< of the states that are drawn
};

namespace runtime {

/// The same without matrices.
struct found_base_parameters {
  std::vector<int> columns{};
  std::vector<double> combination{}; ///< by rows
  std::vector<std::string> names{};
  mechanics::sentence failure{};
};

KANEXPR_ENGINE found_base_parameters find_base_parameters(model& m, std::span<const double> p,
                                                          const base_parameter_options& options);

} // namespace runtime

/// Finds them at random states, which satisfy the constraints, of a system with the parameters `p`: lengths
/// enter the combinations. A parameter that follows from those before it is combined with them, so what is
/// left stands near the ground, body by body in the order of the system.
template <class Parameters = Eigen::VectorXd>
base_parameters find_base_parameters(model& m, const Parameters& p = {},
                                     const base_parameter_options& options = {}) {
  using by_rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const runtime::found_base_parameters found =
      runtime::find_base_parameters(m, runtime::entries_of(p), options);
  const auto rows = static_cast<Eigen::Index>(found.columns.size()),
             entries = static_cast<Eigen::Index>(found.combination.size());
  return {{found.columns.begin(), found.columns.end()},
          Eigen::Map<const by_rows>(found.combination.data(), rows, rows == 0 ? 0 : entries / rows),
          found.names,
          found.failure};
}

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/engine/base_parameters.hpp>
#endif
