#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace kanexpr {

/// Running mean, variance and extremes (Welford, Technometrics 4, 1962). NaN is counted and ignored.
class statistics {
public:
  void take(double number) {
    if (numeric::is_nan(number)) {
      ++missing_;
      return;
    }
    ++count_;
    least_ = (std::min)(least_, number), greatest_ = (std::max)(greatest_, number);
    if (!numeric::is_finite(number)) return;
    const auto count = static_cast<double>(count_);
    const double before = number - mean_; // may overflow
    mean_ += numeric::is_finite(before) ? before / count : number / count - mean_ / count;
    squares_ += before * (number - mean_);
  }

  std::uint64_t count() const { return count_; }
  std::uint64_t missing() const { return missing_; } ///< the number of NaN
  /// NaN without numbers. Infinite if a number is infinite, and NaN if there are infinite numbers of both
  /// signs.
  double mean() const { return count_ == 0 ? none : are_finite() ? mean_ : least_ + greatest_; }
  /// The unbiased estimate, with n − 1: NaN for fewer than two numbers, or if one of them is infinite.
  double variance() const {
    return count_ > 1 && are_finite() ? squares_ / static_cast<double>(count_ - 1) : none;
  }
  double deviation() const { return std::sqrt(variance()); }
  /// The standard error of the mean.
  double error_of_mean() const { return std::sqrt(variance() / static_cast<double>(count_)); }
  double least() const { return count_ > 0 ? least_ : none; }
  double greatest() const { return count_ > 0 ? greatest_ : none; }

  static void fields(auto& self, auto& archive) {
    archive(self.count_, self.missing_, self.mean_, self.squares_, self.least_, self.greatest_);
  }

private:
  bool are_finite() const { return numeric::is_finite(least_) && numeric::is_finite(greatest_); }

  static constexpr double none = numeric::not_a_number<double>;
  std::uint64_t count_ = 0, missing_ = 0;
  double mean_ = 0, squares_ = 0;
  double least_ = numeric::infinity<double>;
  double greatest_ = -numeric::infinity<double>;
};

} // namespace kanexpr
