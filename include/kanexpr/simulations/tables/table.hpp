#pragma once

#include <kanexpr/base/outcome.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr {

namespace simulations {

/// Returns, for example, "1 number" or "2 numbers".
inline std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Returns a name and its unit as in the header of a table: "q1 [rad]", or "q1" if the unit is unknown.
inline std::string header(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

} // namespace simulations

/// Named columns of equal length, with their units if these are known: `for (double angle : run["q1"]) …`.
class table {
public:
  /// A view of a column; empty and with a cause if the table has no column of that name.
  class column : public std::span<const double> {
  public:
    explicit column(const std::vector<double>& values, std::string unit = {})
        : std::span<const double>(values.data(), values.size()), unit_(std::move(unit)) {}
    explicit column(outcome missing) : found_(std::move(missing)) {}

    explicit operator bool() const { return static_cast<bool>(found_); }
    std::string cause() const { return found_.cause(); }
    /// The unit of the numbers, such as "rad"; empty if it is unknown.
    const std::string& unit() const { return unit_; }

  private:
    std::string unit_{};
    outcome found_{};
  };

  table() = default;
  /// Represents a table that could not be read; every function that uses it reports the cause.
  explicit table(outcome failed) : read_(std::move(failed)) {}

  explicit operator bool() const { return static_cast<bool>(read_); }
  std::string cause() const { return read_.cause(); }

  /// Adds a column; the unit of its numbers is empty if it is unknown.
  outcome add(std::string name, std::vector<double> values, std::string unit = {}) {
    if (!read_) return read_;
    if (name.empty()) return outcome("a column has no name");
    if ((name + unit).find('\0') != std::string::npos)
      return outcome("the name of a column contains a zero byte");
    if (place_of(name) < columns()) return outcome("column " + name + " already exists");
    if (columns() != 0 && values.size() != rows())
      return outcome("column " + name + " has " + simulations::counted(values.size(), "number") +
                     ", but the columns before it have " + std::to_string(rows()));
    names_.push_back(std::move(name));
    units_.push_back(std::move(unit));
    values_.push_back(std::move(values));
    return {};
  }

  /// Returns the column with a name, or with a header such as "q1 [rad]".
  column operator[](std::string_view name) const& {
    if (!read_) return column(read_);
    std::size_t place = place_of(name);
    for (std::size_t i = 0; i < columns() && place == columns(); ++i)
      if (header(i) == name) place = i;
    if (place < columns()) return column(values_[place], units_[place]);
    return column(outcome("the table has no column " + std::string(name) + "; it has " + enumerated_names()));
  }
  column operator[](std::string_view name) const&& = delete; // the column would outlive the table

  std::size_t rows() const { return values_.empty() ? 0 : values_.front().size(); }
  std::size_t columns() const { return names_.size(); }
  const std::vector<std::string>& names() const { return names_; }
  /// The units of the columns; those that are unknown are empty.
  const std::vector<std::string>& units() const { return units_; }
  /// Returns the name and the unit of the column at an index: "q1 [rad]", or "q1" if the unit is unknown.
  std::string header(std::size_t place) const { return simulations::header(names_[place], units_[place]); }
  /// Returns the numbers of the column at an index.
  const std::vector<double>& values(std::size_t place) const { return values_[place]; }

private:
  std::size_t place_of(std::string_view name) const {
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }
  std::string enumerated_names() const {
    if (names_.empty()) return "none";
    std::string all = names_.front();
    for (std::size_t i = 1; i < columns(); ++i) all += (i + 1 < columns() ? ", " : " and ") + names_[i];
    return all;
  }

  std::vector<std::string> names_{}, units_{};
  std::vector<std::vector<double>> values_{}; ///< by column
  outcome read_{};
};

} // namespace kanexpr
