#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace kanexpr {

/// Mean, variance and extremes of numbers as they come (Welford, Technometrics 4, 1962). What is not a number
/// is counted and left out.
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
    const double before = number - mean_; // beyond the greatest number, perhaps
    mean_ += numeric::is_finite(before) ? before / count : number / count - mean_ / count;
    squares_ += before * (number - mean_);
  }

  std::uint64_t count() const { return count_; }
  std::uint64_t missing() const { return missing_; } ///< how many were not numbers
  /// Not a number where there are none. Infinite if one of them is, and not a number if both infinities are
  /// among them.
  double mean() const { return count_ == 0 ? none : are_finite() ? mean_ : least_ + greatest_; }
  /// Of the population that the numbers are drawn from, with n − 1; not a number below two numbers, or where
  /// one of them is infinite. Infinite where it is greater than numbers can say.
  double variance() const {
    return count_ > 1 && are_finite() ? squares_ / static_cast<double>(count_ - 1) : none;
  }
  double deviation() const { return std::sqrt(variance()); }
  /// How far the mean of so many draws is from that of all, as a standard deviation.
  double error_of_mean() const { return std::sqrt(variance() / static_cast<double>(count_)); }
  double least() const { return count_ > 0 ? least_ : none; }
  double greatest() const { return count_ > 0 ? greatest_ : none; }

  void write(bytes_writer& out) const {
    out.put(count_), out.put(missing_), out.put(mean_), out.put(squares_), out.put(least_),
        out.put(greatest_);
  }
  void read(bytes_reader& in) {
    count_ = in.get<std::uint64_t>(), missing_ = in.get<std::uint64_t>();
    mean_ = in.get<double>(), squares_ = in.get<double>();
    least_ = in.get<double>(), greatest_ = in.get<double>();
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
