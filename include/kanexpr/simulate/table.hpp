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

/// Columns of equally many numbers, each with a name: `for (double angle : run["q1"]) …`.
class table {
public:
  /// A column, whose numbers stay there; without numbers and with a cause where the table has none
  /// of that name.
  class column : public std::span<const double> {
  public:
    explicit column(const std::vector<double>& values) : std::span<const double>(values) {}
    explicit column(outcome missing) : found_(std::move(missing)) {}

    explicit operator bool() const { return static_cast<bool>(found_); }
    const std::string& cause() const { return found_.cause(); }

  private:
    outcome found_{};
  };

  outcome add(std::string name, std::vector<double> values) {
    if (name.empty()) return outcome("a column has no name");
    if (name.find('\0') != std::string::npos) return outcome("the name of a column holds a zero byte");
    if (place_of(name) < columns()) return outcome("there is a column " + name + " already");
    if (columns() != 0 && values.size() != rows())
      return outcome("column " + name + " has " + std::to_string(values.size()) +
                     (values.size() == 1 ? " number" : " numbers") + ", the columns before it " +
                     std::to_string(rows()));
    names_.push_back(std::move(name));
    values_.push_back(std::move(values));
    return {};
  }

  column operator[](std::string_view name) const& {
    const std::size_t place = place_of(name);
    if (place < columns()) return column(values_[place]);
    return column(outcome("the table has no column " + std::string(name) + "; it has " + enumerated_names()));
  }
  column operator[](std::string_view name) const&& = delete; // which the column would outlive

  std::size_t rows() const { return values_.empty() ? 0 : values_.front().size(); }
  std::size_t columns() const { return names_.size(); }
  const std::vector<std::string>& names() const { return names_; }
  /// Of the column at a place.
  const std::vector<double>& values(std::size_t place) const { return values_[place]; }

private:
  std::size_t place_of(std::string_view name) const {
    return static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
  }

  std::string enumerated_names() const {
    if (names_.empty()) return "none";
    std::string all = names_.front();
    for (std::size_t i = 1; i < columns(); ++i) all += (i + 1 < columns() ? ", " : " and ") + names_[i];
    return all;
  }

  std::vector<std::string> names_{};
  std::vector<std::vector<double>> values_{}; ///< by column
};

} // namespace kanexpr
