#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/evaluate_steps.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <utility>

namespace kanexpr::lower {

/// A statement of straight-line code: a new value computed from preceding values.
struct statement {
  enum class kind : unsigned char {
    number,    ///< `numbers[a]`
    argument,  ///< `arguments[a]`
    operation, ///< `op` applied to the value a, or to the values a and b
    choice,    ///< the value a if the value `by` is positive, otherwise b
    call,      ///< the function `externals[by]` of b values, listed starting at `operands[a]`
    solution,  ///< an array, the solution of `systems[a]`
    entry,     ///< the entry b of the array a
  };
  kind is = kind::number;
  lower::operation op{};
  int a = 0, b = 0, by = 0;
};

/// A symmetric system that is solved for one column after another. Its operands are listed in the code: the
/// factors, then the right-hand sides row by row, like the entries of the solution.
struct solved_columns {
  int order = 0;
  int columns = 0;
  int operands = 0; ///< the index of the first operand
  numeric::column_steps steps{};
  sequence<char> is_given{}; ///< whether each row of the right-hand sides differs from zero

  int factors() const { return numeric::symmetric_factors{order}.size(); }
  int right_side(int row, int column) const { return operands + factors() + row * columns + column; }
};

/// A tape as code that assigns every value once, using only operations that any language provides and calls
/// to user-supplied functions. Backends that generate code use this form. Linear systems are written out,
/// with each row exchange as two choices; those with many columns only if the code has no loops. In each
/// sine-cosine pair, the cosine follows the sine.
struct statements {
  sequence<symbolic::number> numbers{};
  sequence<load> arguments{};
  sequence<statement> lines{}; ///< line i computes the value i
  sequence<int> results{};     ///< indices of values
  sequence<int> operands{};    ///< of calls and systems, as indices of values
  sequence<const symbolic::external_function*> externals{};
  sequence<solved_columns> systems{};
  bool has_loops = false;
};

/// A value of generated code: evaluating a tape with this type generates the code. A value that does not
/// belong to any code is a plain number.
struct written_value {
  statements* code = nullptr;
  int place = 0;
  double number = 0;

  constexpr written_value() = default;
  constexpr written_value(double plain) : number(plain) {}
  constexpr written_value(statements& in, int line) : code(&in), place(line) {}
};

namespace detail {

constexpr written_value write(statements& code, const statement& line) {
  return {code, code.lines.push(line)};
}

constexpr int place_in(statements& code, const written_value& v) {
  if (v.code != nullptr) return v.place;
  return code.lines.push({.a = code.numbers.push(symbolic::real(v.number))});
}

constexpr written_value write(operation op, const written_value& a, const written_value& b) {
  statements& code = *(a.code != nullptr ? a.code : b.code);
  const int first = place_in(code, a);
  const int second = symbolic::is_binary(op) ? place_in(code, b) : 0;
  return write(code, {statement::kind::operation, op, first, second});
}
constexpr written_value write(operation op, const written_value& a) { return write(op, a, a); }

constexpr written_value choose(const written_value& by, const written_value& a, const written_value& b) {
  statements& code = *by.code;
  const int first = place_in(code, a), second = place_in(code, b);
  if (first == second) return a;
  return write(code, {statement::kind::choice, {}, first, second, by.place});
}

} // namespace detail

constexpr written_value operator-(const written_value& a) { return detail::write(operation::negate, a); }
constexpr written_value operator+(const written_value& a, const written_value& b) {
  return detail::write(operation::add, a, b);
}
constexpr written_value operator-(const written_value& a, const written_value& b) {
  return detail::write(operation::subtract, a, b);
}
constexpr written_value operator*(const written_value& a, const written_value& b) {
  return detail::write(operation::multiply, a, b);
}
constexpr written_value operator/(const written_value& a, const written_value& b) {
  if (a.code == nullptr && b.code == nullptr) return a.number / b.number; // a weight such as 1/3
  return detail::write(operation::divide, a, b);
}

template <>
struct scalar_math<written_value> {
  static constexpr written_value from(const written_value& x) { return x; }
  static constexpr void sincos(const written_value& angle, written_value& sine, written_value& cosine) {
    sine = detail::write(operation::sin, angle);
    cosine = detail::write(operation::cos, angle);
  }
  template <operation op>
  static constexpr written_value by_name(const written_value& x) {
    return detail::write(op, x);
  }
  static constexpr written_value called(const symbolic::external_function& f, const written_value* x) {
    statements& code = *x[0].code;
    sequence<int> operands;
    for (int i = 0; i < f.operands; ++i) operands.push(detail::place_in(code, x[i]));
    const int first = code.operands.size();
    for (int each : operands) code.operands.push(each);
    int which = code.externals.find(&f);
    if (which < 0) which = code.externals.push(&f);
    return detail::write(code, {statement::kind::call, operation::call, first, f.operands, which});
  }
  /// Writes a loop over the columns, unless the code may contain no loops.
  static bool solve_columns(const numeric::column_steps& steps, int order, int columns,
                            const written_value* factors, written_value* x) {
    statements& code = *factors[0].code;
    if (!code.has_loops) return false;
    solved_columns system{order, columns, code.operands.size(), steps};
    for (int i = 0; i < system.factors(); ++i) code.operands.push(detail::place_in(code, factors[i]));
    for (int i = 0; i < order * columns; ++i) code.operands.push(detail::place_in(code, x[i]));
    for (int i = 0; i < order; ++i) system.is_given.push(is_given(steps, i) ? 1 : 0);
    const written_value all =
        detail::write(code, {.is = statement::kind::solution, .a = code.systems.push(system)});
    for (int i = 0; i < order * columns; ++i)
      if (steps.filled[i / columns] != 0)
        x[i] = detail::write(code, {.is = statement::kind::entry, .a = all.place, .b = i});
    return true;
  }
  static constexpr written_value power(const written_value& x, const written_value& y) {
    return detail::write(operation::power, x, y);
  }
  template <operation op>
  static constexpr written_value by_name(const written_value& a, const written_value& b) {
    return detail::write(op, a, b);
  }
  template <operation op>
  static constexpr written_value selected(const written_value& condition, const written_value& x) {
    const written_value opposite = -condition, nothing = from(0);
    if (op == operation::if_positive)
      return detail::choose(condition, x, detail::choose(opposite, nothing, condition));
    return detail::choose(condition, nothing,
                          detail::choose(opposite, x, x - by_name<operation::abs>(condition)));
  }
  static constexpr void exchange_if_positive(const written_value& d, written_value& a, written_value& b) {
    const written_value upper = detail::choose(d, b, a), lower = detail::choose(d, a, b);
    a = upper;
    b = lower;
  }

private:
  /// A row is given unless the first step that names it fills it.
  static bool is_given(const numeric::column_steps& steps, int row) {
    for (const numeric::column_step& s : steps.all) {
      if (s.from == row) return true;
      if (s.to == row) return !s.fills;
    }
    return false;
  }
};

/// Calls `use` with the index of each value that a line reads.
template <class Use>
void for_each_operand(const statements& code, const statement& line, const Use& use) {
  using kind = statement::kind;
  switch (line.is) {
  case kind::number:
  case kind::argument: return;
  case kind::call:
    for (int i = 0; i < line.b; ++i) use(code.operands[line.a + i]);
    return;
  case kind::solution: {
    const solved_columns& system = code.systems[line.a];
    for (const numeric::column_step& s : system.steps.all) use(code.operands[system.operands + s.factor]);
    for (int i = 0; i < system.order; ++i)
      for (int j = 0; j < system.columns && system.is_given[i] != 0; ++j)
        use(code.operands[system.right_side(i, j)]);
    return;
  }
  case kind::entry: use(line.a); return;
  case kind::operation:
    use(line.a);
    if (symbolic::is_binary(line.op)) use(line.b);
    return;
  case kind::choice: use(line.by), use(line.a), use(line.b); return;
  }
}

namespace detail {

/// Returns only the lines that the results need; some entries of exchanged rows, for example, are not needed.
inline statements without_unused(const statements& all) {
  using kind = statement::kind;
  sequence<char> is_used(all.lines.size(), 0);
  for (int place : all.results) is_used[place] = 1;
  for (int i = all.lines.size() - 1; i >= 0; --i)
    if (is_used[i] != 0) for_each_operand(all, all.lines[i], [&](int place) { is_used[place] = 1; });
  statements kept = all;
  kept.lines = {}, kept.results = {};
  sequence<int> place(all.lines.size(), 0);
  for (int i = 0; i < all.lines.size(); ++i) {
    if (is_used[i] == 0) continue;
    statement line = all.lines[i];
    if (line.is == kind::operation || line.is == kind::choice)
      line.a = place[line.a], line.b = place[line.b], line.by = place[line.by];
    if (line.is == kind::entry) line.a = place[line.a];
    if (line.is == kind::call)
      for (int k = 0; k < line.b; ++k) kept.operands[line.a + k] = place[all.operands[line.a + k]];
    if (line.is == kind::solution) {
      const solved_columns& system = all.systems[line.a];
      for (int k = system.operands; k < system.right_side(system.order, 0); ++k)
        kept.operands[k] = place[all.operands[k]];
    }
    place[i] = kept.lines.push(line);
  }
  for (int each : all.results) kept.results.push(place[each]);
  return kept;
}

} // namespace detail

/// Appends the code of a tape, with the same operations in the same order as in every other evaluation, and
/// returns the results; `argument` returns the value of a load.
template <class Argument>
sequence<written_value> write(statements& all, const tape& code, const Argument& argument) {
  sequence<written_value> values(code.slot_count()), aside(aside_of(code)), results;
  for (int i = 0; i < code.numbers.size(); ++i)
    values[i] = detail::write(all, {.a = all.numbers.push(code.numbers[i])});
  for (int i = 0; i < code.loads.size(); ++i) values[code.numbers.size() + i] = argument(code.loads[i]);
  evaluate_steps(code, values.begin(), aside.begin());
  for (int slot : code.results) results.push(values[slot]);
  return results;
}

/// Appends an argument to generated code and returns it.
inline written_value argument_of(statements& all, const load& from) {
  return detail::write(all, {.is = statement::kind::argument, .a = all.arguments.push(from)});
}

/// Completes the code: sets its results and removes the lines that they do not need.
inline statements concluded(statements& all, const sequence<written_value>& results) {
  for (const written_value& each : results) all.results.push(detail::place_in(all, each));
  return detail::without_unused(all);
}

namespace detail {

/// The number of sums that can be evaluated together with a product that nothing else uses.
inline int fused_sums(const statements& code) {
  sequence<int> uses(code.lines.size(), 0);
  for (const statement& line : code.lines) for_each_operand(code, line, [&](int place) { ++uses[place]; });
  for (int place : code.results) ++uses[place];
  const auto is_single_product = [&](int place) {
    const statement& line = code.lines[place];
    return line.is == statement::kind::operation && line.op == operation::multiply && uses[place] == 1;
  };
  int fused = 0;
  for (const statement& line : code.lines)
    if (line.is == statement::kind::operation &&
        (line.op == operation::add || line.op == operation::subtract) &&
        (is_single_product(line.a) || is_single_product(line.b)))
      ++fused;
  return fused;
}

} // namespace detail

/// Returns the cost of one evaluation of the code; all choices that test the same value count as one
/// comparison.
inline symbolic::cost cost_of(const statements& code) {
  symbolic::cost total;
  sequence<char> is_compared(code.lines.size(), 0);
  for (int i = 0; i < code.lines.size(); ++i) {
    const statement& line = code.lines[i];
    if (line.is == statement::kind::call) total.count(operation::call);
    if (line.is == statement::kind::solution)
      total.count_columns(code.systems[line.a].steps, code.systems[line.a].columns);
    if (line.is == statement::kind::choice && std::exchange(is_compared[line.by], char{1}) == 0)
      total.count(operation::subtract);
    if (line.is != statement::kind::operation) continue;
    total.count(line.op);
    const statement* const before = i > 0 ? &code.lines[i - 1] : nullptr;
    if (line.op == operation::cos && before != nullptr && before->is == line.is &&
        before->op == operation::sin && before->a == line.a)
      --total.trigonometric; // counted with the sine of the same angle
  }
  total.fused += detail::fused_sums(code);
  return total;
}

/// Returns the code of a tape. `has_loops` permits loops over the columns of symmetric systems.
inline statements statements_of(const tape& code, bool has_loops = false) {
  statements all;
  all.has_loops = has_loops;
  const sequence<written_value> results =
      write(all, code, [&](const load& from) { return argument_of(all, from); });
  return concluded(all, results);
}

} // namespace kanexpr::lower
