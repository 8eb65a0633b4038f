#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/code_table.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/evaluate_steps.hpp>
#include <kanexpr/lower/regular.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <vector>

namespace kanexpr::runtime {

/// Interprets the code table of a function with one scalar type.
template <class Number>
class table_interpreter {
public:
  table_interpreter(const compiled::code_table& table, const derivation::survey& known)
      : table_(table), known_(known), slots_(static_cast<std::size_t>(table.tape.slot_count())),
        aside_(static_cast<std::size_t>(lower::aside_of(table.tape))) {
    for (int i = 0; i < table.tape.numbers.size(); ++i)
      slots_[static_cast<std::size_t>(i)] = lower::number_as<Number>(table.tape.numbers[i]);
  }

  /// Writes the results consecutively, each row by row.
  status evaluate(const Number& t, const Number* x, const Number* p, const Number* r, Number* results) {
    Number* load = slots_.data() + table_.tape.numbers.size();
    for (const lower::load& each : table_.tape.loads) *load++ = value_of(each, t, x, p, r);
    lower::evaluate_steps(table_.tape, slots_.data(), aside_.data());
    const int all = table_.tape.results.size() - 2 * table_.causes;
    for (int i = 0; i < all; ++i) results[i] = found(i);
    for (int i = 0; i < table_.causes; ++i)
      if (!passes(i, found(all + 2 * i), found(all + 2 * i + 1))) return status(table_.cause(i));
    return {};
  }

private:
  const Number& found(int result) const {
    return slots_[static_cast<std::size_t>(table_.tape.results[result])];
  }

  Number value_of(const lower::load& l, const Number& t, const Number* x, const Number* p,
                  const Number* r) const {
    using symbolic::symbol_kind;
    if (l.from == symbol_kind::time) return t;
    if (l.from == symbol_kind::coordinate) return x[l.position];
    if (l.from == symbol_kind::speed) return x[known_.coordinates + l.position];
    return (l.from == symbol_kind::parameter ? p : r)[l.position];
  }

  bool passes(int cause, const Number& measure, const Number& scale) const {
    constexpr double least = base::least_singularity_measure<Number>();
    return table_.tells_finiteness && cause == table_.causes - 1
               ? lower::passes<true>(measure, scale, least)
               : lower::passes<false>(measure, scale, least);
  }

  const compiled::code_table& table_;
  const derivation::survey& known_;
  std::vector<Number> slots_, aside_;
};

} // namespace kanexpr::runtime
