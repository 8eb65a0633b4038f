#pragma once

#include <kanexpr/steps/unit_quaternions.hpp>

#include <vector>

namespace kanexpr::simulated {

/// The quaternions of a system whose norm 1 its motion keeps.
class unit_norms {
public:
  explicit unit_norms(const deriving::survey& known) : places_(static_cast<std::size_t>(known.quaternions)) {
    for (int i = 0; i < known.coordinates; ++i) {
      if (known.quaternion_of[i] == 0) continue;
      places_[static_cast<std::size_t>(known.quaternion_of[i] - 1)].push_back(i);
      are_bound_ = are_bound_ || known.dependent[i];
    }
    for (int k = 0; k < known.quaternions; ++k)
      far_from_one_.push_back(mechanics::sentence(
          {"the norm of ", compiled::quaternion_called(known, k).view(), " is far from 1"}));
  }

  int count() const { return static_cast<int>(places_.size()); }
  /// Whether a constraint is solved for a coordinate of one of them.
  bool are_bound() const { return are_bound_; }

  /// Gives each of them norm 1; the status names one whose norm is out of the range.
  status normalize(Eigen::VectorXd& x, const lower::norm_range& from) const {
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (!lower::normalize(x, places_[k], from)) return status(far_from_one_[k].view());
    return {};
  }

  /// Their norms less 1, to first order, and the derivatives of these by all coordinates.
  template <class Number>
  Number residual(int k, const Number* x) const {
    Number square = 0;
    for (const int place : places_of(k)) square += x[place] * x[place];
    return (square - 1.0) / 2.0;
  }
  const std::vector<int>& places_of(int k) const { return places_[static_cast<std::size_t>(k)]; }

  /// Derivatives by all coordinates of a function that gives the quaternions norm 1 first.
  void leave_out(Eigen::MatrixXd& by_all, const Eigen::VectorXd& x) const {
    for (const std::vector<int>& places : places_) lower::leave_norm_out(by_all, x, places);
  }

private:
  std::vector<std::vector<int>> places_;
  std::vector<mechanics::sentence> far_from_one_{};
  bool are_bound_ = false;
};

} // namespace kanexpr::simulated
