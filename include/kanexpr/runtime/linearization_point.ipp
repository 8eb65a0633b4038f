#pragma once

#include <kanexpr/runtime/linearization_point.hpp>

namespace kanexpr {

KANEXPR_ENGINE linearization_point::linearization_point(std::initializer_list<entry> entries) {
  for (const entry& e : entries) {
    const std::size_t known = entries_.size();
    set(e.what, e.value);
    if (entries_.size() == known) doubled_.push_back(e.what);
  }
}

KANEXPR_ENGINE linearization_point& linearization_point::set(const symbol_name& what,
                                                             const point_value& value) {
  for (entry& e : entries_)
    if (e.what == what) {
      e.value = value;
      return *this;
    }
  entries_.push_back({what, value});
  return *this;
}

KANEXPR_ENGINE linearization_point linearization_point::with(const linearization_point& other) const {
  linearization_point both = *this;
  for (const entry& e : other.entries_) both.set(e.what, e.value);
  both.doubled_.insert(both.doubled_.end(), other.doubled_.begin(), other.doubled_.end());
  return both;
}

} // namespace kanexpr
