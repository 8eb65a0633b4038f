// Random units.
#pragma once

#include "mechanics/random/dice.hpp"
#include "mechanics/random/in_units.hpp"

namespace soak {

// The conversion that is applied to a mechanism.
struct wanted {
  double decades = 9; // the range of units, in both directions
  bool hostile_states = true;
  double planted = 0; ///< the relative error of one load that the derivatives must reveal
};

inline double any_power(dice& d, const wanted& w) { return std::pow(10.0, d.between(-w.decades, w.decades)); }
inline recipe::units any_units(dice& d, const wanted& w) {
  const double length = any_power(d, w), mass = any_power(d, w), time = any_power(d, w);
  return {length, mass, time};
}

inline recipe::constants any_constants(dice& d) {
  return d.chance(0.5) ? recipe::constants::numbers : recipe::constants::symbols;
}

// Results in the original units: each row and column is divided by its unit.
inline Eigen::MatrixXd in_old_units(Eigen::MatrixXd found, const std::vector<double>& rows,
                                    const std::vector<double>& columns = {}, double whole = 1) {
  for (Eigen::Index i = 0; i < found.rows(); ++i)
    for (Eigen::Index j = 0; j < found.cols(); ++j) {
      found(i, j) /= rows[static_cast<std::size_t>(i)] * whole;
      if (!columns.empty()) found(i, j) /= columns[static_cast<std::size_t>(j)];
    }
  return found;
}

inline std::vector<double> inverse(std::vector<double> units) {
  for (double& unit : units) unit = 1 / unit;
  return units;
}
inline std::vector<double> some_of(const std::vector<double>& units,
                                   const kanexpr::base::sequence<int>& which) {
  std::vector<double> some;
  for (int i : which) some.push_back(units[static_cast<std::size_t>(i)]);
  return some;
}

} // namespace soak
