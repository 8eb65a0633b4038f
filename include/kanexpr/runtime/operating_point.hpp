#pragma once

#include <kanexpr/describe/expression.hpp>
#include <kanexpr/symbolic/expression.hpp>

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kanexpr {

/// The value of a symbol at an operating point: a number (whole numbers are kept exactly), an expression in
/// the words of a model such as `v / r`, or an expression of a model that was derived.
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

/// What is given a value: a symbol of the model, `dot(q1)` or `dot(u1)` for rates among them, or its name as
/// it is printed: "q1", "q1'".
class point_name {
public:
  point_name(const scalar<1>& symbol) : symbol_(symbol.tokens[0].symbol) {
    if (symbol_ != nullptr) name_ = symbol_->called.view();
  }
  point_name(std::string_view name) : name_(name) {}
  point_name(const char* name) : name_(name) {}
  point_name(const std::string& name) : name_(name) {}

  const describe::symbol_record* symbol() const { return symbol_; } ///< null: there is the name alone
  const std::string& name() const { return name_; }
  bool operator==(const point_name& other) const {
    return name_ == other.name_ && (symbol_ == nullptr) == (other.symbol_ == nullptr) &&
           (symbol_ == nullptr || symbol_->kind == other.symbol_->kind);
  }

private:
  const describe::symbol_record* symbol_ = nullptr;
  std::string name_;
};

/// Where a system is linearized, as named values: `operating_point{{q1, 0}, {u1, 2.5}, {u2, v / r}}`. What it
/// does not name stays a symbol; rates that it does not name are those of the motion.
class operating_point {
public:
  struct entry {
    point_name what;
    point_value value;
  };

  operating_point() = default;
  operating_point(std::initializer_list<entry> entries) {
    for (const entry& e : entries) set(e.what, e.value);
  }

  operating_point& set(const point_name& what, const point_value& value) {
    for (entry& e : entries_)
      if (e.what == what) {
        e.value = value;
        return *this;
      }
    entries_.push_back({what, value});
    return *this;
  }

  /// Both sets of values; where both name a symbol, the other's value counts.
  operating_point with(const operating_point& other) const {
    operating_point both = *this;
    for (const entry& e : other.entries_) both.set(e.what, e.value);
    return both;
  }

  const std::vector<entry>& entries() const { return entries_; }

private:
  std::vector<entry> entries_;
};

} // namespace kanexpr
