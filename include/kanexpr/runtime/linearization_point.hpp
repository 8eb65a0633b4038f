#pragma once

#include <kanexpr/describe/symbol_name.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <algorithm>
#include <concepts>
#include <initializer_list>
#include <variant>
#include <vector>

namespace kanexpr {

/// The value of a symbol at an operating point: a number (integers are exact), an expression in a system's
/// symbols such as `v / r`, or an expression of a derived model.
class point_value {
public:
  template <std::integral Whole>
  point_value(Whole value) : held_(symbolic::exactly(static_cast<std::int64_t>(value))) {}
  template <std::floating_point Real>
  point_value(Real value) : held_(symbolic::real(static_cast<double>(value))) {}
  template <int size>
  point_value(const scalar<size>& words) : held_(phrase(words.tokens, words.tokens + size)) {}
  point_value(symbolic::expression e) : held_(e) {}

  using phrase = std::vector<describe::token>;
  const std::variant<symbolic::number, phrase, symbolic::expression>& held() const { return held_; }

private:
  std::variant<symbolic::number, phrase, symbolic::expression> held_;
};

/// An operating point for linearization, as named values: `linearization_point{{q1, 0}, {u1, 2.5}, {u2, v /
/// r}}`. Symbols that the point does not name are kept; rates that it does not name follow from the equations
/// of motion.
class linearization_point {
public:
  struct entry {
    symbol_name what;
    point_value value;
  };

  linearization_point() = default;
  linearization_point(std::initializer_list<entry> entries) {
    for (const entry& e : entries) {
      const std::size_t known = entries_.size();
      set(e.what, e.value);
      if (entries_.size() == known) duplicates_.push_back(e.what);
    }
  }

  linearization_point& set(const symbol_name& what, const point_value& value) {
    const auto known = std::ranges::find(entries_, what, &entry::what);
    if (known != entries_.end())
      known->value = value;
    else
      entries_.push_back({what, value});
    return *this;
  }

  /// Merges both sets of values; if both name a symbol, the value of `other` is used.
  linearization_point with(const linearization_point& other) const {
    linearization_point both = *this;
    for (const entry& e : other.entries_) both.set(e.what, e.value);
    both.duplicates_.insert(both.duplicates_.end(), other.duplicates_.begin(), other.duplicates_.end());
    return both;
  }

  const std::vector<entry>& entries() const { return entries_; }
  /// The symbols that a list names twice, which is a mistake.
  const std::vector<symbol_name>& duplicates() const { return duplicates_; }

private:
  std::vector<entry> entries_{};
  std::vector<symbol_name> duplicates_{};
};

} // namespace kanexpr
