#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/model.hpp>

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

/// The base parameters of a system: the smallest set of combinations of the inertial parameters of its bodies
/// that determines the inverse dynamics, π_base = K π with Y π = Y_base π_base. Only these can be identified
/// by experiments (Gautier, Numerical Calculation of the Base Inertial Parameters of Robots, Journal of
/// Robotic Systems 8, 1991).
struct base_parameters {
  std::vector<Eigen::Index> columns{};           ///< the columns of Y that form Y_base
  Eigen::MatrixXd combination{};                 ///< K
  std::vector<std::string> names{};              ///< "izz of Upper + 0.25*m of Lower"
  std::vector<mechanics::possible_unit> units{}; ///< in the same order; empty if the system states no units
  base::sentence failure{};                      ///< the reason why no base parameters were found

  explicit operator bool() const { return !failure; }
  std::string cause() const { return failure.cause(); }

  /// The columns Y_base of a regressor Y.
  template <class Regressor>
  Eigen::MatrixXd columns_of(const Eigen::MatrixBase<Regressor>& y) const {
    Eigen::MatrixXd base(y.rows(), static_cast<Eigen::Index>(columns.size()));
    for (Eigen::Index j = 0; j < base.cols(); ++j) base.col(j) = y.col(columns[static_cast<std::size_t>(j)]);
    return base;
  }
};

/// Options of the search for base parameters.
struct base_parameter_options {
  /// The tolerance, relative to the length of a column; shorter remainders count as zero.
  double tolerance = 1e-9;
  std::uint64_t seed = 1; ///< seed of the random states
};

namespace runtime {

/// The base parameters in plain vectors instead of matrices.
struct found_base_parameters {
  std::vector<int> columns{};
  std::vector<double> combination{}; ///< row by row
  std::vector<std::string> names{};
  std::vector<mechanics::possible_unit> units{};
  base::sentence failure{};
};

KANEXPR_ENGINE found_base_parameters find_base_parameters(model& m, std::span<const double> p,
                                                          const base_parameter_options& options);

} // namespace runtime

/// Finds the base parameters of a system with the parameters `p`, from random states that satisfy the
/// constraints. The combinations depend on the lengths in `p`. A parameter that depends on preceding ones is
/// combined with them, so the remaining parameters belong to the bodies closest to the ground, in the order
/// of the system.
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
          found.units,
          found.failure};
}

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/base_parameters.ipp>
#endif
