// The number of comparisons, and the worst error of each kind.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace soak {

struct worst {
  double error = 0;
  unsigned seed = 0;
  long count = 0;
};

class errors {
public:
  static constexpr double tolerance = 1e-11;

  void begin(unsigned seed) { seed_ = seed, reason_.clear(); }

  // Compares numbers with their expected values, relative to `scale` and to the largest of these.
  void compare(const std::string& what, const Eigen::MatrixXd& found, const Eigen::MatrixXd& wanted,
               double scale) {
    if (found.rows() != wanted.rows() || found.cols() != wanted.cols())
      return fail(what + " has another size");
    double size = scale, error = 0;
    for (Eigen::Index i = 0; i < wanted.size(); ++i) size = std::max(size, std::abs(wanted.data()[i]));
    for (Eigen::Index i = 0; i < wanted.size(); ++i) {
      const double off = std::abs(found.data()[i] - wanted.data()[i]) / size;
      if (!(off <= error)) error = off; // or is NaN
    }
    if (error != error) error = std::numeric_limits<double>::infinity();
    worst& so_far = by_what_[what];
    ++so_far.count;
    if (!(error <= so_far.error)) so_far = {error, seed_, so_far.count};
    if (!(error <= tolerance)) fail(what + " is off by " + std::to_string(error / tolerance) + " tolerances");
  }
  void expect(bool holds, const std::string& otherwise) {
    if (!holds) fail(otherwise);
  }

  // The reason why the mechanism with this seed failed; empty if it did not.
  const std::string& reason() const { return reason_; }
  const std::map<std::string, worst>& by_what() const { return by_what_; }

private:
  void fail(const std::string& why) {
    if (reason_.empty()) reason_ = why;
  }

  unsigned seed_ = 0;
  std::string reason_;
  std::map<std::string, worst> by_what_;
};

} // namespace soak
