#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/printing/print.hpp>
#include <kanexpr/symbolic/printing/writer.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::symbolic {

namespace printing {

class plain_text_form : public writer<plain_text_form> {
public:
  using writer::writer;

  std::string product(const side& s) const {
    std::string text = s.shows_number() ? number_of(s.coefficient) : "";
    for (const factor& f : s.factors) text += (text.empty() ? "" : "*") + text_of(f);
    return text;
  }
  std::string quotient(const side& above, const side& below) const {
    const std::string divisor = product(below);
    return product(above) + "/" + (below.size() > 1 ? in_parentheses(divisor) : divisor);
  }
  std::string function(int id) const {
    const node& n = at(id);
    if (n.op == operation::component) {
      const node& solution = at(n.a);
      return "solve(" + matrix_of(solution.a, solution.op == operation::transposed_solve) + ", " +
             list(elements(solution.b)) + ")[" + std::to_string(integer_at(owner(), n.b) + 1) + "]";
    }
    if (n.op == operation::singularity_measure)
      return "singularity_measure(" + matrix_of(n.a, false) + ", " + list(elements(n.b)) + ")";
    if (is_selection(n.op)) return conditional(id);
    if (n.op == operation::call)
      return std::string(owner().external_at(id).called.view()) + "(" + separated(elements(n.a)) + ")";
    std::string text = function_name(n.op) + ("(" + write(n.a));
    if (is_binary(n.op)) text += ", " + write(n.b);
    return text + ")";
  }
  std::string conditional_of(const std::string& condition, const std::string& positive,
                             const std::string& other) const {
    return "if_positive(" + condition + ", " + positive + ", " + other + ")";
  }
  std::string name_of(const symbol& s) const {
    const bool is_rate = s.kind == symbol_kind::coordinate_rate || s.kind == symbol_kind::speed_rate;
    return std::string(s.called.view()) + (is_rate ? "'" : "");
  }
  std::string number_of(const number& n) const { return decimal(n); }
  std::string exponent(int id) const { return operand(id); }
  std::string power(const std::string& base, const std::string& exponent) const {
    return base + "^" + exponent;
  }
  std::string raised(int base, const std::string& exponent) const { return power(operand(base), exponent); }
  std::string in_parentheses(const std::string& text) const { return "(" + text + ")"; }

private:
  std::string list(const std::vector<int>& nodes) const { return "[" + separated(nodes) + "]"; }
  std::string matrix_of(int factorization, bool transposed) const {
    std::string text;
    for (const std::vector<int>& row : rows_of(factorization, transposed))
      text += (text.empty() ? "" : ", ") + list(row);
    return "[" + text + "]";
  }
};

} // namespace printing

KANEXPR_ENGINE std::string print(const graph& g, int id) { return printing::plain_text_form(g).write(id); }
KANEXPR_ENGINE std::string print(expression e) { return print(e.owner(), e.node()); }

namespace printing {

/// The number of characters in a UTF-8 text.
inline std::size_t width_of(std::string_view text) {
  const auto begins_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return static_cast<std::size_t>(std::ranges::count_if(text, begins_letter));
}

} // namespace printing

KANEXPR_ENGINE std::string print(const matrix& m, std::string_view before) {
  using printing::width_of;
  std::vector<std::string> entries;
  std::vector<std::size_t> widths(static_cast<std::size_t>(m.columns));
  for (const expression& e : m.entries) {
    std::size_t& width = widths[entries.size() % widths.size()];
    entries.push_back(print(e));
    width = (std::max)(width, width_of(entries.back()));
  }
  std::string text(before);
  const std::string margin(width_of(before.substr(before.rfind('\n') + 1)), ' ');
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t column = i % widths.size();
    if (column == 0) text += i == 0 ? "[" : "\n" + margin + "[";
    text += entries[i];
    const bool is_last = column + 1 == widths.size();
    if (!is_last) text += ", ";
    text.append(widths[column] - width_of(entries[i]), ' ');
    if (is_last) text += "]";
  }
  return text;
}

} // namespace kanexpr::symbolic
