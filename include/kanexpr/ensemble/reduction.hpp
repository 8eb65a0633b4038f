#pragma once

#include <kanexpr/ensemble/histogram.hpp>
#include <kanexpr/ensemble/quantile_sketch.hpp>
#include <kanexpr/ensemble/statistics.hpp>
#include <kanexpr/ensemble/value_counts.hpp>

#include <string>
#include <utility>
#include <variant>

namespace kanexpr {

/// What is formed of a column over all runs, as they come: `statistics_of("height")`. Runs that failed are
/// not in it.
struct reduction {
  std::string column;
  std::variant<statistics, quantile_sketch, histogram, value_counts> what;

  void take(double number) {
    std::visit([&](auto& one) { one.take(number); }, what);
  }
  void write(bytes_writer& out) const {
    std::visit([&](const auto& one) { one.write(out); }, what);
  }
  void read(bytes_reader& in) {
    std::visit([&](auto& one) { one.read(in); }, what);
  }
};

inline reduction statistics_of(std::string column) { return {std::move(column), statistics()}; }
inline reduction quantiles_of(std::string column) { return {std::move(column), quantile_sketch()}; }
/// Equal bins from a number to another, which belongs to none of them.
inline reduction histogram_of(std::string column, double from, double to, std::size_t bins) {
  return {std::move(column), histogram(from, to, bins)};
}
/// How often each number came, for counts and other whole numbers.
inline reduction counts_of(std::string column) { return {std::move(column), value_counts()}; }

} // namespace kanexpr
