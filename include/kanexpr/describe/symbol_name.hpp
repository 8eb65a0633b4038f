#pragma once

#include <kanexpr/describe/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string>
#include <string_view>

namespace kanexpr {

/// Identifies a quantity at run time: a symbol of the model, including rates such as `dot(q1)` or `dot(u1)`,
/// or its name as printed: "q1", "q1'".
class symbol_name {
public:
  symbol_name(const scalar<1>& symbol) : symbol_(symbol.tokens[0].symbol) {
    if (symbol_ == nullptr) return;
    name_ = symbol_->called.view();
    if (symbol_->kind == symbolic::symbol_kind::coordinate_rate ||
        symbol_->kind == symbolic::symbol_kind::speed_rate)
      name_ += '\''; // the record of a rate contains the name of the symbol itself
  }
  symbol_name(std::string_view name) : name_(name) {}
  symbol_name(const char* name) : name_(name) {}
  symbol_name(const std::string& name) : name_(name) {}
  symbol_name(const symbol_name&) = default;
  symbol_name(symbol_name&&) = default;
  symbol_name& operator=(const symbol_name&) = default;
  symbol_name& operator=(symbol_name&&) = default;

  const describe::symbol_record* symbol() const { return symbol_; } ///< null if only the name is known
  const std::string& name() const { return name_; }                 ///< empty for a number
  bool operator==(const symbol_name& other) const { return name_ == other.name_; }

private:
  const describe::symbol_record* symbol_ = nullptr;
  std::string name_{};
};

} // namespace kanexpr
