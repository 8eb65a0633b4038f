#pragma once

#include <kanexpr/ensembles/histogram.hpp>
#include <kanexpr/ensembles/quantile_sketch.hpp>
#include <kanexpr/ensembles/statistics.hpp>
#include <kanexpr/ensembles/value_counts.hpp>

#include <string>
#include <utility>
#include <variant>

namespace kanexpr {

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

inline reduction statistics_of(std::string column) { return {std::move(column), statistics()}; }
inline reduction quantiles_of(std::string column) { return {std::move(column), quantile_sketch()}; }
/// Equal bins between two numbers, of which the second is excluded.
inline reduction histogram_of(std::string column, double from, double to, std::size_t bins) {
  return {std::move(column), histogram(from, to, bins)};
}
/// The frequency of each value, for counts and other integers.
inline reduction counts_of(std::string column) { return {std::move(column), value_counts()}; }

} // namespace kanexpr
