#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace kanexpr {

/// Quantiles of numbers as they come, of which it keeps few: exact up to `room` numbers, and then within a
/// rank that it tells.
///
/// A full level of numbers is sorted, and every other one of them goes to the next level, where each counts
/// twice (Manku, Rajagopalan & Lindsay, SIGMOD 1998): that moves the rank of any number by at most the weight
/// of one. The odd and the even ones go in turn, so that most of it cancels.
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
  std::uint64_t missing() const { return missing_; } ///< how many were not numbers
  /// By how many places of the sorted numbers a quantile may be off, at worst.
  std::uint64_t rank_error() const { return rank_error_; }

  /// The number below which this part of them lies: quantile(0.5) is the median, quantile(0) the least. Not a
  /// number where there are none, or the part is not between 0 and 1.
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

  void write(bytes_writer& out) const {
    out.put(count_), out.put(missing_), out.put(rank_error_), out.put(least_), out.put(greatest_);
    out.put(levels_.size());
    for (const level& each : levels_) out.put(each.numbers), out.put(each.takes_odd);
  }
  void read(bytes_reader& in) {
    count_ = in.get<std::uint64_t>(), missing_ = in.get<std::uint64_t>(),
    rank_error_ = in.get<std::uint64_t>(), least_ = in.get<double>(), greatest_ = in.get<double>();
    levels_.clear();
    for (auto left = in.get<std::size_t>(); left > 0 && in; --left) {
      levels_.emplace_back();
      levels_.back().numbers = in.get_all<double>();
      levels_.back().takes_odd = in.get<bool>();
    }
  }

private:
  struct level {
    std::vector<double> numbers{};
    bool takes_odd = false;
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
