#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/code_table.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <algorithm>
#include <vector>

namespace kanexpr::runtime {

/// Interprets the code table of a function in one scalar type.
template <class Number>
class table_interpreter {
public:
  table_interpreter(const compiled::code_table& table, const derivation::survey& known)
      : table_(table), known_(known), code_(table.tape), found_(static_cast<std::size_t>(code_.size())) {}

  /// Writes the results consecutively, each row by row.
  status evaluate(const Number& t, const Number* x, const Number* p, const Number* r, Number* results) {
    code_.evaluate([&](const lower::load& each) { return value_of(each, t, x, p, r); }, found_.data());
    const Number* checked = found_.data() + found_.size() - 2 * static_cast<std::size_t>(table_.causes);
    std::copy(static_cast<const Number*>(found_.data()), checked, results);
    for (int i = 0; i < table_.causes; ++i, checked += 2) {
      const bool of_finiteness = table_.checks_finiteness && i == table_.causes - 1;
      if (!passes(of_finiteness, checked[0], checked[1])) return status(table_.cause(i));
    }
    return {};
  }

private:
  Number value_of(const lower::load& l, const Number& t, const Number* x, const Number* p,
                  const Number* r) const {
    using symbolic::symbol_kind;
    if (l.from == symbol_kind::time) return t;
    if (l.from == symbol_kind::coordinate) return x[l.position];
    if (l.from == symbol_kind::speed) return x[known_.coordinates + l.position];
    return (l.from == symbol_kind::parameter ? p : r)[l.position];
  }

  const compiled::code_table& table_;
  const derivation::survey& known_;
  interpreter<Number, lower::tape_view> code_;
  std::vector<Number> found_;
};

} // namespace kanexpr::runtime
