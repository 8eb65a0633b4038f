#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/simulations/tables/table.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr {

KANEXPR_SIMULATIONS outcome table::add(std::string name, std::vector<double> values) {
  if (!read_) return read_;
  if (name.empty()) return outcome("a column has no name");
  if (name.find('\0') != std::string::npos) return outcome("the name of a column contains a zero byte");
  if (place_of(name) < columns()) return outcome("column " + name + " already exists");
  if (columns() != 0 && values.size() != rows())
    return outcome("column " + name + " has " + std::to_string(values.size()) +
                   (values.size() == 1 ? " number" : " numbers") + ", but the columns before it have " +
                   std::to_string(rows()));
  names_.push_back(std::move(name));
  values_.push_back(std::move(values));
  return {};
}

KANEXPR_SIMULATIONS table::column table::operator[](std::string_view name) const& {
  if (!read_) return column(read_);
  const std::size_t place = place_of(name);
  if (place < columns()) return column(values_[place]);
  return column(outcome("the table has no column " + std::string(name) + "; it has " + enumerated_names()));
}

KANEXPR_SIMULATIONS std::size_t table::place_of(std::string_view name) const {
  return static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
}

KANEXPR_SIMULATIONS std::string table::enumerated_names() const {
  if (names_.empty()) return "none";
  std::string all = names_.front();
  for (std::size_t i = 1; i < columns(); ++i) all += (i + 1 < columns() ? ", " : " and ") + names_[i];
  return all;
}

} // namespace kanexpr
