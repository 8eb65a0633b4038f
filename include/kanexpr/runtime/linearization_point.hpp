#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/describe/symbol_name.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <concepts>
#include <cstdint>
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

  linearization_point();
  linearization_point(std::initializer_list<entry> entries);
  linearization_point(const linearization_point&);
  linearization_point(linearization_point&&) noexcept;
  linearization_point& operator=(const linearization_point&);
  linearization_point& operator=(linearization_point&&) noexcept;
  ~linearization_point();

  linearization_point& set(const symbol_name& what, const point_value& value);

  /// Merges both sets of values; if both name a symbol, the value of `other` is used.
  linearization_point with(const linearization_point& other) const;

  const std::vector<entry>& entries() const { return entries_; }
  /// The symbols that a list names twice, which is a mistake.
  const std::vector<symbol_name>& duplicates() const { return duplicates_; }

private:
  std::vector<entry> entries_{};
  std::vector<symbol_name> duplicates_{};
};

namespace runtime {

/// Returns the point at a time and the values [q; u; p; r] of all symbols of a system.
KANEXPR_ENGINE linearization_point point_with(const derivation::survey& known, double t,
                                              const double* values);

} // namespace runtime

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/linearization_point.ipp>
#endif
