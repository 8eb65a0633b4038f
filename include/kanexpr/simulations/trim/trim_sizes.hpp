#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/trim/trim_conditions.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kanexpr::simulations {

/// The magnitudes of the symbols and functions of a system, in their units, estimated from one point and the
/// derivatives there. A length is assigned its own magnitude or, if it is near zero, that of the greatest
/// length; a speed has the magnitude that its acceleration would give it over the distance of its coordinate;
/// a state variable near zero has the magnitude at which it would balance the other terms of its rate; an
/// unknown input or parameter has the magnitude that changes a function by the magnitude of that function.
/// The magnitude of a function follows from those of its symbols.
class sizes {
public:
  /// The arguments specify which coordinates are angles or belong to quaternions, the values of the
  /// symbols [x; p; r], the derivatives of the functions [residuals; ẋ] with respect to them, and a length
  /// known from elsewhere, or 0.
  sizes(const conditions& of, const std::vector<bool>& angles, const Eigen::VectorXd& values,
        const Eigen::MatrixXd& slope, double usual)
      : of_(of), angles_(angles), coordinates_(of.known().coordinates),
        speeds_(of.known().speeds - of.known().state_variables), slope_(slope.cwiseAbs()),
        symbols_(values.cwiseAbs()), usual_(usual) {
    size_coordinates();
    size_speeds();
    size_state_variables();
    size_unknowns();
    size_functions();
  }

  const Eigen::VectorXd& symbols() const { return symbols_; }
  const Eigen::VectorXd& functions() const { return functions_; }

  /// Returns the largest magnitude of the coordinates that are not angles.
  static double longest(const std::vector<bool>& angles, const Eigen::VectorXd& values) {
    double length = 0;
    for (std::size_t j = 0; j < angles.size(); ++j)
      if (!angles[j]) length = (std::max)(length, std::abs(values(static_cast<Eigen::Index>(j))));
    return length;
  }

private:
  bool is_angle(int coordinate) const { return angles_[static_cast<std::size_t>(coordinate)]; }
  int rate_of(int state) const { return of_.residuals() + state; }
  double reached(int function) const {
    return slope_.row(function).cwiseProduct(symbols_.transpose()).maxCoeff();
  }

  /// Returns the change of a symbol that changes one of the functions by its magnitude; 0 if no function
  /// depends on it.
  double effective(int symbol) const {
    double least = 0;
    for (int i = 0; i < slope_.rows(); ++i) {
      const double change = reached(i) / slope_(i, symbol);
      if (change > 0 && numeric::is_finite(change)) least = least > 0 ? (std::min)(least, change) : change;
    }
    return least;
  }

  void size_coordinates() {
    const double length = (std::max)(usual_, longest(angles_, symbols_));
    for (int j = 0; j < coordinates_; ++j)
      if (is_angle(j))
        symbols_(j) = (std::max)(1.0, symbols_(j));
      else if (symbols_(j) <= 1e-6 * length)
        symbols_(j) = length;
    if (length > 0) return;
    for (int j = 0; j < coordinates_; ++j)
      if (!is_angle(j)) {
        const double found = effective(j);
        symbols_(j) = found > 0 ? found : 1;
      }
  }

  /// A speed that is zero, or nonzero only because of rounding, is assigned the typical magnitude of the
  /// other speeds.
  void size_speeds() {
    Eigen::VectorXd distances = Eigen::VectorXd::Zero(speeds_);
    std::vector<double> rates;
    for (int k = 0; k < speeds_; ++k) {
      double &distance = distances(k), &size = symbols_(coordinates_ + k);
      for (int j = 0; j < coordinates_; ++j) {
        const double found = symbols_(j) / slope_(rate_of(j), coordinates_ + k);
        if (numeric::is_finite(found) && found > 0)
          distance = distance > 0 ? (std::min)(distance, found) : found;
      }
      size = (std::max)(size, std::sqrt(reached(rate_of(coordinates_ + k)) * distance));
      if (size > 0 && distance > 0) rates.push_back(size / distance);
    }
    if (!rates.empty()) {
      const auto middle = rates.begin() + static_cast<std::ptrdiff_t>(rates.size() / 2);
      std::nth_element(rates.begin(), middle, rates.end());
      rate_ = *middle;
    }
    for (int k = 0; k < speeds_; ++k) {
      double& size = symbols_(coordinates_ + k);
      size = (std::max)(size, distances(k) * rate_);
      if (!(size > 0)) size = 1;
    }
  }

  /// The state variables that are near zero, such as the deflection of a tyre that is not driven. If the rate
  /// of a state variable has no other terms, it is compared with those of another function that contains it.
  void size_state_variables() {
    const Eigen::VectorXd given = symbols_;
    for (int z = coordinates_ + speeds_; z < of_.states(); ++z) {
      double found = balancing(rate_of(z), z, given);
      for (int i = 0; i < slope_.rows() && !(found > 0); ++i) found = balancing(i, z, given);
      double& size = symbols_(z);
      if (size <= 1e-6 * found) size = found;
      if (!(size > 0)) size = 1;
    }
  }

  /// Returns the value of a symbol at which its term in a function is as large as the largest other term; 0
  /// if there is none.
  double balancing(int function, int symbol, const Eigen::VectorXd& given) const {
    Eigen::VectorXd terms = slope_.row(function).transpose().cwiseProduct(given);
    terms(symbol) = 0;
    const double found = terms.maxCoeff() / slope_(function, symbol);
    return numeric::is_finite(found) ? found : 0;
  }

  void size_unknowns() {
    for (const int s : of_.unknowns()) {
      if (s < of_.states()) continue;
      const double most = slope_.col(s).maxCoeff();
      double found = effective(s);
      if (!(found > 0) && most > 0) found = 1 / most;
      symbols_(s) = (std::max)(symbols_(s), found > 0 ? found : 1.0);
    }
  }

  void size_functions() {
    functions_.resize(slope_.rows());
    for (int i = 0; i < functions_.size(); ++i) functions_(i) = reached(i);
    for (int s = 0; s < of_.states(); ++s) {
      double& rate = functions_(rate_of(s));
      rate = (std::max)(rate, rate_ * symbols_(s));
    }
    for (double& size : functions_)
      if (!(size > 0)) size = 1;
  }

  const conditions& of_;
  const std::vector<bool>& angles_;
  int coordinates_, speeds_;
  Eigen::MatrixXd slope_;
  Eigen::VectorXd symbols_, functions_{};
  double usual_, rate_ = 1; ///< a length, and the typical ratio of a speed to its distance
};

} // namespace kanexpr::simulations
