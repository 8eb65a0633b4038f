#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kanexpr::simulations {

/// The positions and kinds of the symbols [x; p; r] and of the functions [residuals; ẋ].
struct layout {
  int coordinates = 0, speeds = 0, residuals = 0;
  std::vector<bool> angles{};   ///< by coordinate: angles, and coordinates of quaternions
  std::vector<bool> unknowns{}; ///< by symbol

  int rate_of(int state) const { return residuals + state; }
  bool is_angle(int coordinate) const { return angles[static_cast<std::size_t>(coordinate)]; }
};

/// The magnitudes of the symbols and functions of a system, in their units, estimated from one point and the
/// derivatives there. A length has its own magnitude, or that of the longest if it is near zero; a speed has
/// the magnitude that its acceleration gives it over the distance of its coordinate; an input or parameter to
/// be found has the magnitude that changes a function by its magnitude. The magnitude of a function follows
/// from those of its symbols.
class sizes {
public:
  /// `usual` is a length known from elsewhere, or 0.
  sizes(const layout& of, const Eigen::VectorXd& values, const Eigen::MatrixXd& slope, double usual)
      : of_(of), slope_(slope.cwiseAbs()), symbols_(values.cwiseAbs()), usual_(usual) {
    size_coordinates();
    size_speeds();
    size_unknowns();
    size_functions();
  }

  const Eigen::VectorXd& symbols() const { return symbols_; }
  const Eigen::VectorXd& functions() const { return functions_; }

  /// Returns the largest magnitude of the coordinates that are not angles.
  static double longest(const layout& of, const Eigen::VectorXd& values) {
    double length = 0;
    for (int j = 0; j < of.coordinates; ++j)
      if (!of.is_angle(j)) length = (std::max)(length, std::abs(values(j)));
    return length;
  }

private:
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
    const double length = (std::max)(usual_, longest(of_, symbols_));
    for (int j = 0; j < of_.coordinates; ++j)
      if (of_.is_angle(j))
        symbols_(j) = (std::max)(1.0, symbols_(j));
      else if (symbols_(j) <= 1e-6 * length)
        symbols_(j) = length;
    if (length > 0) return;
    for (int j = 0; j < of_.coordinates; ++j)
      if (!of_.is_angle(j)) {
        const double found = effective(j);
        symbols_(j) = found > 0 ? found : 1;
      }
  }

  /// A speed that is zero, or due only to rounding, is as fast as the others typically are.
  void size_speeds() {
    Eigen::VectorXd ways = Eigen::VectorXd::Zero(of_.speeds);
    std::vector<double> rates;
    for (int k = 0; k < of_.speeds; ++k) {
      double &way = ways(k), &size = symbols_(of_.coordinates + k);
      for (int j = 0; j < of_.coordinates; ++j) {
        const double found = symbols_(j) / slope_(of_.rate_of(j), of_.coordinates + k);
        if (numeric::is_finite(found) && found > 0) way = way > 0 ? (std::min)(way, found) : found;
      }
      size = (std::max)(size, std::sqrt(reached(of_.rate_of(of_.coordinates + k)) * way));
      if (size > 0 && way > 0) rates.push_back(size / way);
    }
    if (!rates.empty()) {
      const auto middle = rates.begin() + static_cast<std::ptrdiff_t>(rates.size() / 2);
      std::nth_element(rates.begin(), middle, rates.end());
      rate_ = *middle;
    }
    for (int k = 0; k < of_.speeds; ++k) {
      double& size = symbols_(of_.coordinates + k);
      size = (std::max)(size, ways(k) * rate_);
      if (!(size > 0)) size = 1;
    }
  }

  void size_unknowns() {
    for (int s = of_.coordinates + of_.speeds; s < symbols_.size(); ++s) {
      if (!of_.unknowns[static_cast<std::size_t>(s)]) continue;
      const double most = slope_.col(s).maxCoeff();
      double found = effective(s);
      if (!(found > 0) && most > 0) found = 1 / most;
      symbols_(s) = (std::max)(symbols_(s), found > 0 ? found : 1.0);
    }
  }

  void size_functions() {
    functions_.resize(slope_.rows());
    for (int i = 0; i < functions_.size(); ++i) functions_(i) = reached(i);
    for (int s = 0; s < of_.coordinates + of_.speeds; ++s) {
      double& rate = functions_(of_.rate_of(s));
      rate = (std::max)(rate, rate_ * symbols_(s));
    }
    for (double& size : functions_)
      if (!(size > 0)) size = 1;
  }

  const layout& of_;
  Eigen::MatrixXd slope_;
  Eigen::VectorXd symbols_, functions_{};
  double usual_, rate_ = 1; ///< a length, and the typical ratio of a speed to its distance
};

} // namespace kanexpr::simulations
