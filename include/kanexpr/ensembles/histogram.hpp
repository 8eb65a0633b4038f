#pragma once

#include <kanexpr/ensembles/lerp.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kanexpr {

/// Counts numbers in equal bins between two numbers, of which the second is excluded.
class histogram {
public:
  static constexpr std::size_t max_bins = std::size_t{1} << 24;

  histogram() = default;
  /// A histogram with a negative number of bins, or too many, has none; a study refuses it.
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
      std::size_t bin = 0; // compared with the edges, because other formulas round differently
      for (std::size_t end = bins(); end - bin > 1;) {
        const std::size_t middle = bin + (end - bin) / 2;
        (number < edge(middle) ? end : bin) = middle;
      }
      ++counts_[bin];
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
  std::uint64_t missing() const { return missing_; } ///< the number of NaN

  static void fields(auto& self, auto& archive) {
    archive(self.from_, self.to_, self.counts_, self.below_, self.above_, self.missing_);
  }

private:
  double from_ = 0, to_ = 0;
  std::vector<std::uint64_t> counts_{};
  std::uint64_t below_ = 0, above_ = 0, missing_ = 0;
};

} // namespace kanexpr
