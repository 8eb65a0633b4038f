#pragma once

#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/describe/symbol.hpp>
#include <kanexpr/describe/symbol_name.hpp>
#include <kanexpr/runtime/linearization_point.hpp>

#include <algorithm>
#include <cstddef>
#include <initializer_list>

namespace kanexpr {

KANEXPR_ENGINE linearization_point::linearization_point() = default;
KANEXPR_ENGINE linearization_point::linearization_point(const linearization_point&) = default;
KANEXPR_ENGINE linearization_point::linearization_point(linearization_point&&) noexcept = default;
KANEXPR_ENGINE linearization_point& linearization_point::operator=(const linearization_point&) = default;
KANEXPR_ENGINE linearization_point& linearization_point::operator=(linearization_point&&) noexcept = default;
KANEXPR_ENGINE linearization_point::~linearization_point() = default;

KANEXPR_ENGINE linearization_point::linearization_point(std::initializer_list<entry> entries) {
  for (const entry& e : entries) {
    const std::size_t known = entries_.size();
    set(e.what, e.value);
    if (entries_.size() == known) duplicates_.push_back(e.what);
  }
}

KANEXPR_ENGINE linearization_point& linearization_point::set(const symbol_name& what,
                                                             const point_value& value) {
  const auto known = std::ranges::find(entries_, what, &entry::what);
  if (known != entries_.end())
    known->value = value;
  else
    entries_.push_back({what, value});
  return *this;
}

KANEXPR_ENGINE linearization_point linearization_point::with(const linearization_point& other) const {
  linearization_point both = *this;
  for (const entry& e : other.entries_) both.set(e.what, e.value);
  both.duplicates_.insert(both.duplicates_.end(), other.duplicates_.begin(), other.duplicates_.end());
  return both;
}

namespace runtime {

KANEXPR_ENGINE linearization_point point_with(const derivation::survey& known, double t,
                                              const double* values) {
  linearization_point point;
  point.set(time_variable(), t);
  for (int i = 0; i < known.symbols(); ++i) point.set(known.names[i].view(), values[i]);
  return point;
}

} // namespace runtime

} // namespace kanexpr
