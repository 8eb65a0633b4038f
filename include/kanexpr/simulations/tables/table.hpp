#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/simulations/compiled_simulations.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr {

/// Named columns of equal length: `for (double angle : run["q1"]) …`.
class table {
public:
  /// A view of a column; empty and with a cause if the table has no column of that name.
  class column : public std::span<const double> {
  public:
    explicit column(const std::vector<double>& values) : std::span<const double>(values) {}
    explicit column(outcome missing) : found_(std::move(missing)) {}

    explicit operator bool() const { return static_cast<bool>(found_); }
    std::string cause() const { return found_.cause(); }

  private:
    outcome found_{};
  };

  table() = default;
  /// Creates a table that could not be read, with the cause, which every function that uses the table
  /// reports.
  explicit table(outcome failed) : read_(std::move(failed)) {}

  explicit operator bool() const { return static_cast<bool>(read_); }
  std::string cause() const { return read_.cause(); }

  outcome add(std::string name, std::vector<double> values);

  column operator[](std::string_view name) const&;
  column operator[](std::string_view name) const&& = delete; // the column would outlive the table

  std::size_t rows() const { return values_.empty() ? 0 : values_.front().size(); }
  std::size_t columns() const { return names_.size(); }
  const std::vector<std::string>& names() const { return names_; }
  /// Returns the numbers of the column at an index.
  const std::vector<double>& values(std::size_t place) const { return values_[place]; }

private:
  std::size_t place_of(std::string_view name) const;
  std::string enumerated_names() const;

  std::vector<std::string> names_{};
  std::vector<std::vector<double>> values_{}; ///< by column
  outcome read_{};
};

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_SIMULATIONS
#include <kanexpr/simulations/tables/table.ipp>
#endif
