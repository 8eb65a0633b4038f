#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensemble/between.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kanexpr {

/// How many numbers fall into each of equal bins from a number to another, which belongs to none of them.
class histogram {
public:
  static constexpr std::size_t most_bins = std::size_t{1} << 24;

  histogram() = default;
  /// Without bins where there would be too many, of which a negative number is one; a study refuses that.
  histogram(double from, double to, std::size_t bins)
      : from_(from), to_(to), counts_(bins <= most_bins ? bins : 0) {}

  void take(double number) {
    if (numeric::is_nan(number)) {
      ++missing_;
    } else if (number < from_) {
      ++below_;
    } else if (number >= to_) {
      ++above_;
    } else {
      std::size_t bin = 0; // the edges themselves decide, for any other sum rounds otherwise
      for (std::size_t end = bins(); end - bin > 1;) {
        const std::size_t middle = bin + (end - bin) / 2;
        (number < edge(middle) ? end : bin) = middle;
      }
      ++counts_[bin];
    }
  }

  std::size_t bins() const { return counts_.size(); }
  /// How many x there are with edge(bin) ≤ x < edge(bin + 1); none where there is no such bin.
  std::uint64_t count(std::size_t bin) const { return bin < bins() ? counts_[bin] : 0; }
  /// Where a bin begins; that behind the last is the end.
  double edge(std::size_t bin) const {
    return bin < bins()
               ? ensembles::between(from_, to_, static_cast<double>(bin) / static_cast<double>(bins()))
               : to_;
  }
  std::uint64_t below() const { return below_; }
  std::uint64_t above() const { return above_; }
  std::uint64_t missing() const { return missing_; } ///< how many were not numbers

  void write(bytes_writer& out) const {
    out.put(from_), out.put(to_), out.put(counts_);
    out.put(below_), out.put(above_), out.put(missing_);
  }
  void read(bytes_reader& in) {
    from_ = in.get<double>(), to_ = in.get<double>(), counts_ = in.get_all<std::uint64_t>();
    below_ = in.get<std::uint64_t>(), above_ = in.get<std::uint64_t>(), missing_ = in.get<std::uint64_t>();
  }

private:
  double from_ = 0, to_ = 0;
  std::vector<std::uint64_t> counts_{};
  std::uint64_t below_ = 0, above_ = 0, missing_ = 0;
};

} // namespace kanexpr
