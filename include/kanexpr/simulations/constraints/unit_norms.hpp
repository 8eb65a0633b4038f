#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/steps/unit_quaternions.hpp>

#include <Eigen/Core>
#include <vector>

namespace kanexpr::simulations {

/// The quaternions of a system. The motion preserves their unit norm.
class unit_norms {
public:
  explicit unit_norms(const derivation::survey& known)
      : places_(static_cast<std::size_t>(known.quaternions)) {
    for (int i = 0; i < known.coordinates; ++i) {
      if (known.quaternion_of[i] == 0) continue;
      places_[static_cast<std::size_t>(known.quaternion_of[i] - 1)].push_back(i);
      are_bound_ = are_bound_ || known.dependent[i];
    }
    for (int k = 0; k < known.quaternions; ++k) far_from_one_.push_back(steps::far_from_norm_1(known, k));
  }

  int count() const { return static_cast<int>(places_.size()); }
  /// Whether a constraint is solved for a coordinate of a quaternion.
  bool are_bound() const { return are_bound_; }

  /// Normalizes each quaternion; the status reports one whose norm is out of range.
  status normalize(Eigen::VectorXd& x, const lower::norm_range& from) const {
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (!lower::normalize(x, places_[k], from)) return status(far_from_one_[k].view());
    return {};
  }

  /// Returns the norm of a quaternion minus 1, to first order.
  template <class Number>
  Number residual(int k, const Number* x) const {
    Number square = 0;
    for (const int place : places_of(k)) square += x[place] * x[place];
    return (square - 1.0) / 2.0;
  }
  const std::vector<int>& places_of(int k) const { return places_[static_cast<std::size_t>(k)]; }

  /// Converts derivatives with respect to all coordinates into those of a function that first normalizes the
  /// quaternions.
  void leave_out(Eigen::MatrixXd& by_all, const Eigen::VectorXd& x) const {
    for (const std::vector<int>& places : places_) lower::leave_norm_out(by_all, x, places);
  }

private:
  std::vector<std::vector<int>> places_;
  std::vector<base::sentence> far_from_one_{};
  bool are_bound_ = false;
};

} // namespace kanexpr::simulations
