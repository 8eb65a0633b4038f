#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace kanexpr {

/// Approximate quantiles of a stream of numbers, in little memory: exact up to `room` numbers, then within a
/// reported error of the rank.
///
/// When a level of numbers is full, it is sorted, and every other number moves to the next level, where it
/// counts twice (Manku, Rajagopalan & Lindsay, SIGMOD 1998). This changes the rank of a number by at most the
/// weight of one. Odd and even places alternate, so most of the error cancels.
class quantile_sketch {
public:
  static constexpr std::size_t room = 4096;

  void take(double number) {
    if (numeric::is_nan(number)) {
      ++missing_;
      return;
    }
    ++count_;
    least_ = (std::min)(least_, number), greatest_ = (std::max)(greatest_, number);
    if (levels_.empty()) levels_.emplace_back();
    for (std::size_t i = 0; i < levels_.size() && levels_[i].numbers.size() >= room; ++i) compact(i);
    levels_[0].numbers.push_back(number);
  }

  std::uint64_t count() const { return count_; }
  std::uint64_t missing() const { return missing_; } ///< the number of NaN
  /// The maximum error of a quantile, in places of the sorted numbers.
  std::uint64_t rank_error() const { return rank_error_; }

  /// The number below which this part of them lies: quantile(0.5) is the median, quantile(0) the minimum. NaN
  /// without numbers, or if the part is not between 0 and 1.
  double quantile(double part) const {
    if (count_ == 0 || numeric::is_nan(part) || part < 0 || part > 1) return numeric::not_a_number<double>;
    if (part <= 0) return least_;
    if (part >= 1) return greatest_;
    std::vector<std::pair<double, std::uint64_t>> all;
    for (std::size_t i = 0; i < levels_.size(); ++i)
      for (double number : levels_[i].numbers) all.emplace_back(number, std::uint64_t{1} << i);
    std::sort(all.begin(), all.end());
    // 0.07 of 100 numbers are 7 of them, though 0.07 · 100 is a little more.
    const double wanted = part * static_cast<double>(count_) * (1 - 0x1p-51);
    double below = 0;
    for (const auto& [number, weight] : all) {
      below += static_cast<double>(weight);
      if (below >= wanted) return number;
    }
    return all.back().first;
  }

  static void fields(auto& self, auto& archive) {
    archive(self.count_, self.missing_, self.rank_error_, self.least_, self.greatest_, self.levels_);
  }

private:
  struct level {
    std::vector<double> numbers{};
    bool takes_odd = false;
    static void fields(auto& self, auto& archive) { archive(self.numbers, self.takes_odd); }
  };

  void compact(std::size_t i) {
    if (i + 1 == levels_.size()) levels_.emplace_back();
    level &full = levels_[i], &next = levels_[i + 1];
    std::sort(full.numbers.begin(), full.numbers.end());
    for (std::size_t k = full.takes_odd; k < full.numbers.size(); k += 2)
      next.numbers.push_back(full.numbers[k]);
    full.numbers.clear();
    full.takes_odd = !full.takes_odd;
    rank_error_ += std::uint64_t{1} << i;
  }

  std::vector<level> levels_{};
  std::uint64_t count_ = 0, missing_ = 0, rank_error_ = 0;
  double least_ = numeric::infinity<double>;
  double greatest_ = -numeric::infinity<double>;
};

} // namespace kanexpr
