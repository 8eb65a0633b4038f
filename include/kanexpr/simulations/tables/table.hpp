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

} // namespace simulations

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
  /// Represents a table that could not be read; every function that uses it reports the cause.
  explicit table(outcome failed) : read_(std::move(failed)) {}

  explicit operator bool() const { return static_cast<bool>(read_); }
  std::string cause() const { return read_.cause(); }

  outcome add(std::string name, std::vector<double> values) {
    if (!read_) return read_;
    if (name.empty()) return outcome("a column has no name");
    if (name.find('\0') != std::string::npos) return outcome("the name of a column contains a zero byte");
    if (place_of(name) < columns()) return outcome("column " + name + " already exists");
    if (columns() != 0 && values.size() != rows())
      return outcome("column " + name + " has " + simulations::counted(values.size(), "number") +
                     ", but the columns before it have " + std::to_string(rows()));
    names_.push_back(std::move(name));
    values_.push_back(std::move(values));
    return {};
  }

  column operator[](std::string_view name) const& {
    if (!read_) return column(read_);
    const std::size_t place = place_of(name);
    if (place < columns()) return column(values_[place]);
    return column(outcome("the table has no column " + std::string(name) + "; it has " + enumerated_names()));
  }
  column operator[](std::string_view name) const&& = delete; // the column would outlive the table

  std::size_t rows() const { return values_.empty() ? 0 : values_.front().size(); }
  std::size_t columns() const { return names_.size(); }
  const std::vector<std::string>& names() const { return names_; }
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

  std::vector<std::string> names_{};
  std::vector<std::vector<double>> values_{}; ///< by column
  outcome read_{};
};

} // namespace kanexpr
