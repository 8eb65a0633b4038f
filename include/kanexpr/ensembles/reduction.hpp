#pragma once

#include <kanexpr/ensembles/lerp.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <ranges>
#include <string>
#include <utility>
#include <variant>
#include <vector>

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
  std::uint64_t missing() const { return missing_; } ///< the number of NaNs
  /// Returns NaN if there are no numbers, infinity if a number is infinite, and NaN if there are infinite
  /// numbers of both signs.
  double mean() const { return count_ == 0 ? none : are_finite() ? mean_ : least_ + greatest_; }
  /// Returns the unbiased estimate, with n − 1; NaN for fewer than two numbers, or if one of them is
  /// infinite.
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

/// Approximate quantiles of a stream of numbers, using little memory: exact up to `room` numbers, then within
/// a reported error of the rank.
///
/// When a level of numbers is full, it is sorted, and every other number moves to the next level, where it
/// counts twice (Manku, Rajagopalan & Lindsay, SIGMOD 1998). This changes the rank of a number by at most the
/// weight of one number of that level. Odd and even places alternate, so most of the error cancels.
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
  std::uint64_t missing() const { return missing_; } ///< the number of NaNs
  /// The maximum error of a quantile, as a number of places in the sorted numbers.
  std::uint64_t rank_error() const { return rank_error_; }

  /// Returns the number below which a given fraction of the numbers lies: quantile(0.5) is the median,
  /// quantile(0) the minimum. Returns NaN if there are no numbers, or if the fraction is not between 0 and 1.
  double quantile(double part) const {
    if (count_ == 0 || numeric::is_nan(part) || part < 0 || part > 1) return numeric::not_a_number<double>;
    if (part <= 0) return least_;
    if (part >= 1) return greatest_;
    std::vector<std::pair<double, std::uint64_t>> all;
    for (std::size_t i = 0; i < levels_.size(); ++i)
      for (double number : levels_[i].numbers) all.emplace_back(number, std::uint64_t{1} << i);
    std::sort(all.begin(), all.end());
    // A fraction of 0.07 of 100 numbers is 7 numbers, although 0.07 · 100 is rounded to slightly more.
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

/// Counts numbers in bins of equal width between two bounds, the second of which is excluded.
class histogram {
public:
  static constexpr std::size_t max_bins = std::size_t{1} << 24;

  histogram() = default;
  /// If the number of bins is negative or too large, the histogram has no bins, and a study rejects it.
  histogram(double from, double to, std::size_t bins)
      : from_(from), to_(to), counts_(bins <= max_bins ? bins : 0) {}

  void take(double number) {
    if (numeric::is_nan(number)) {
      ++missing_;
    } else if (number < from_) {
      ++below_;
    } else if (number >= to_) {
      ++above_;
    } else {
      // The number is compared with the edges, because other formulas round differently.
      const auto inner = std::views::iota(std::size_t{1}, bins());
      const auto next = std::ranges::partition_point(inner, [&](auto i) { return number >= edge(i); });
      ++counts_[static_cast<std::size_t>(next - inner.begin())];
    }
  }

  bool is_valid() const { return bins() > 0 && from_ < to_; }
  std::size_t bins() const { return counts_.size(); }
  /// The number of x with edge(bin) ≤ x < edge(bin + 1); 0 if there is no such bin.
  std::uint64_t count(std::size_t bin) const { return bin < bins() ? counts_[bin] : 0; }
  /// The lower edge of a bin; edge(bins()) is the end.
  double edge(std::size_t bin) const {
    return bin < bins() ? ensembles::lerp(from_, to_, static_cast<double>(bin) / static_cast<double>(bins()))
                        : to_;
  }
  std::uint64_t below() const { return below_; }
  std::uint64_t above() const { return above_; }
  std::uint64_t missing() const { return missing_; } ///< the number of NaNs

  static void fields(auto& self, auto& archive) {
    archive(self.from_, self.to_, self.counts_, self.below_, self.above_, self.missing_);
  }

private:
  double from_ = 0, to_ = 0;
  std::vector<std::uint64_t> counts_{};
  std::uint64_t below_ = 0, above_ = 0, missing_ = 0;
};

/// The frequency of each value of a quantity with few values, such as the number of events.
class value_counts {
public:
  static constexpr std::size_t max_values = 1000;

  void take(double number) {
    if (numeric::is_nan(number))
      ++missing_;
    else if (counts_.size() < max_values || counts_.contains(number))
      ++counts_[number];
    else
      ++others_;
  }

  std::uint64_t count(double number) const {
    const auto found = counts_.find(number);
    return found == counts_.end() ? 0 : found->second;
  }
  const std::map<double, std::uint64_t>& counts() const { return counts_; }
  std::uint64_t others() const { return others_; } ///< numbers that differ from the first `max_values` values
  std::uint64_t missing() const { return missing_; } ///< the number of NaNs

  static void fields(auto& self, auto& archive) { archive(self.counts_, self.others_, self.missing_); }

private:
  std::map<double, std::uint64_t> counts_{};
  std::uint64_t others_ = 0, missing_ = 0;
};

/// A summary of a column over all runs that did not fail, updated after each run: `statistics_of("height")`.
struct reduction {
  std::string column;
  std::variant<statistics, quantile_sketch, histogram, value_counts> what;

  void take(double number) {
    std::visit([&](auto& one) { one.take(number); }, what);
  }
  static void fields(auto& self, auto& archive) {
    std::visit([&](auto& one) { archive(one); }, self.what);
  }
};

/// The mean, variance and extremes of a column: `statistics_of("height")`.
inline reduction statistics_of(std::string column) { return {std::move(column), statistics()}; }
/// Quantiles of a column, such as its median: `quantiles_of("height")`.
inline reduction quantiles_of(std::string column) { return {std::move(column), quantile_sketch()}; }
/// Bins of equal width between two bounds, the second of which is excluded.
inline reduction histogram_of(std::string column, double from, double to, std::size_t bins) {
  return {std::move(column), histogram(from, to, bins)};
}
/// The frequency of each value, for counts and other integers.
inline reduction counts_of(std::string column) { return {std::move(column), value_counts()}; }

} // namespace kanexpr
