#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/statements.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/printing/writer.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

namespace runtime {

/// Writes statements as text: `s1 = sin(q1)`. Numbers and arguments are written inline where they are used.
class code_printer {
public:
  code_printer(const lower::statements& code, const symbolic::graph& g) : code_(code), graph_(g) {
    while (is_taken()) separator_ += '_';
    for (const lower::statement& line : code.lines) names_.push_back(name_of(line));
  }

  std::string text() const {
    std::string all;
    for (int i = 0; i < code_.lines.size(); ++i) {
      using kind = lower::statement::kind;
      const lower::statement& line = code_.lines[i];
      if (line.is != kind::number && line.is != kind::argument) all += name(i) + " = " + value(line) + '\n';
    }
    return all;
  }

  const std::string& result(int place) const { return name(code_.results[place]); }

private:
  const std::string& name(int value) const { return names_[static_cast<std::size_t>(value)]; }

  /// The printed name of a symbol.
  static std::string printed(const symbolic::symbol& s) {
    using symbolic::symbol_kind;
    const bool is_rate = s.kind == symbol_kind::coordinate_rate || s.kind == symbol_kind::speed_rate;
    return std::string(s.called.view()) + (is_rate ? "'" : "");
  }

  /// Whether a symbol or a function has a name that the listing could also choose for a value.
  bool is_taken() const {
    for (const symbolic::symbol& s : graph_.symbols())
      if (is_taken_by(s.called.view())) return true;
    for (const symbolic::external_function* f : graph_.externals())
      if (is_taken_by(f->called.view())) return true;
    return false;
  }
  bool is_taken_by(std::string_view called) const {
    for (const char letter : {'s', 'c', 't'}) {
      const std::string begin = letter + separator_;
      if (called.starts_with(begin) && called.size() > begin.size() &&
          called.find_first_not_of("0123456789", begin.size()) == std::string_view::npos)
        return true;
    }
    return false;
  }

  std::string name_of(const lower::statement& line) {
    using kind = lower::statement::kind;
    if (line.is == kind::number) return number(code_.numbers[line.a]);
    if (line.is == kind::argument) return argument(code_.arguments[line.a]);
    if (line.op != symbolic::operation::sin && line.op != symbolic::operation::cos)
      return "t" + separator_ + std::to_string(++values_);
    if (angles_.find(line.a) < 0) angles_.push(line.a);
    return (line.op == symbolic::operation::sin ? "s" : "c") + separator_ +
           std::to_string(angles_.find(line.a) + 1);
  }

  static std::string number(const symbolic::number& n) {
    using symbolic::printing::decimal;
    if (n.denominator <= 1) return decimal(n);
    return decimal(symbolic::exactly(n.numerator)) + '/' + decimal(symbolic::exactly(n.denominator));
  }

  std::string argument(const lower::load& from) const {
    for (const symbolic::symbol& s : graph_.symbols())
      if (s.kind == from.from && s.position == from.position) return printed(s);
    return "";
  }

  /// Adds the parentheses that negative values and quotients need next to an operator.
  static std::string operand(const std::string& text) {
    return text[0] == '-' || text.find('/') != std::string::npos ? '(' + text + ')' : text;
  }

  std::string value(const lower::statement& line) const {
    using symbolic::form;
    if (line.is == lower::statement::kind::call) {
      std::string text(code_.externals[line.by]->called.view());
      for (int i = 0; i < line.b; ++i) text += (i == 0 ? "(" : ", ") + name(code_.operands[line.a + i]);
      return text + ')';
    }
    if (line.is == lower::statement::kind::choice)
      return name(line.by) + " > 0 ? " + name(line.a) + " : " + name(line.b);
    const std::string first = operand(name(line.a)), second = operand(name(line.b));
    switch (symbolic::form_of(line.op)) {
    case form::negate: return '-' + first;
    case form::add: return first + " + " + second;
    case form::subtract: return first + " - " + second;
    case form::multiply: return first + " * " + second;
    case form::divide: return first + " / " + second;
    case form::power: return "pow(" + name(line.a) + ", " + name(line.b) + ')';
    case form::binary_function:
      return symbolic::function_name(line.op) + ('(' + name(line.a)) + ", " + name(line.b) + ')';
    case form::function: return symbolic::function_name(line.op) + ('(' + name(line.a) + ')');
    case form::leaf: // has no line
    case form::selection:
    case form::list_operation: break; // handled elsewhere
    }
    return "";
  }

  const lower::statements& code_;
  const symbolic::graph& graph_;
  std::string separator_{};
  std::vector<std::string> names_{};
  base::sequence<int> angles_{};
  int values_ = 0;
};

} // namespace runtime

/// Returns the code of a result as readable text, one operation per line in the order of execution, followed
/// by the entries, row by row:
///
///     s1 = sin(q)
///     t1 = g * s1
///     udot(0) = t1
///
/// `a > 0 ? b : c` is b if a is positive; the solution of linear systems uses it to exchange rows. The
/// singularity checks of a compiled function are not included.
inline std::string listing(const symbolic::matrix& result, std::string_view called = "result") {
  if (result.entries.empty()) return "";
  const symbolic::graph& g = result.entries[0].owner();
  const lower::statements code = lower::statements_of(lower::tape_of(g, symbolic::nodes_of(result.entries)));
  const runtime::code_printer lines(code, g);
  std::string text = lines.text();
  for (int i = 0; i < result.entries.size(); ++i) {
    text += called;
    if (result.columns > 1)
      text += '(' + std::to_string(i / result.columns) + ", " + std::to_string(i % result.columns) + ')';
    else if (result.rows > 1)
      text += '(' + std::to_string(i) + ')';
    text += " = " + lines.result(i) + '\n';
  }
  return text;
}

/// Returns the code of a named result.
inline std::string listing(model& of, mechanics::quantity wanted) {
  return listing(of.get(wanted), mechanics::row_of(wanted).called);
}

} // namespace kanexpr
