#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>
#include <kanexpr/symbolic/printing/print.hpp>
#include <kanexpr/symbolic/printing/short_text.hpp>
#include <kanexpr/symbolic/printing/text_with_parts.hpp>
#include <kanexpr/symbolic/printing/write_within.hpp>
#include <kanexpr/symbolic/printing/writer.hpp>

#include <algorithm>
#include <cstddef>
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
    if (n.op == operation::component)
      return (is_part(n.a) ? reference(n.a) : function(n.a)) + "[" +
             std::to_string(integer_at(owner(), n.b) + 1) + "]";
    if (is_solution(n.op))
      return "solve(" + matrix_of(n.a, n.op == operation::transposed_solve) + ", " + list(elements(n.b)) +
             ")";
    if (n.op == operation::factorization) return rows(id, false);
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
  std::string name_of_part(const std::string& name) const { return name; }
  std::string number_of(const number& n) const { return decimal(n); }
  std::string exponent(int id) const { return operand(id); }
  std::string power(const std::string& base, const std::string& exponent) const {
    return base + "^" + exponent;
  }
  std::string raised(int base, const std::string& exponent) const { return power(operand(base), exponent); }
  std::string in_parentheses(const std::string& text) const { return "(" + text + ")"; }

  /// Appends the definitions of parts to a text.
  static std::string with_definitions(const std::string& text,
                                      const std::vector<text_with_parts::part>& parts) {
    std::string all = text + "\nwhere";
    for (const text_with_parts::part& each : parts) all.append("\n  " + each.name + " = " + each.text);
    return all;
  }

private:
  std::string list(const std::vector<int>& nodes) const { return "[" + separated(nodes) + "]"; }
  std::string matrix_of(int factorization, bool transposed) const {
    if (!is_part(factorization)) return rows(factorization, transposed);
    return transposed ? "transpose(" + reference(factorization) + ")" : reference(factorization);
  }
  std::string rows(int factorization, bool transposed) const {
    std::string text;
    for (const std::vector<int>& row : rows_of(factorization, transposed))
      text += (text.empty() ? "" : ", ") + list(row);
    return "[" + text + "]";
  }
};

} // namespace printing

KANEXPR_ENGINE std::string print(const graph& g, int id, std::size_t longest) {
  const auto compose = [id](const printing::plain_text_form& form) { return form.write(id); };
  return printing::write_within<printing::plain_text_form>(longest, g, {id}, compose);
}
KANEXPR_ENGINE std::string print(expression e, std::size_t longest) {
  return print(e.owner(), e.node(), longest);
}
KANEXPR_ENGINE std::string print_in_sentence(expression e) {
  constexpr std::size_t longest = 300;
  const printing::plain_text_form form(e.owner(), longest);
  const std::string text = form.write(e.node());
  const bool is_short = !form.is_cut_short() && text.size() <= longest;
  return is_short ? text : std::string(short_text(e.owner(), e.node()).view());
}
KANEXPR_ENGINE text_with_parts print_each(const sequence<expression>& all, std::size_t longest) {
  return printing::write_each<printing::plain_text_form>(longest, all);
}

namespace printing {

/// The number of characters in a UTF-8 text.
inline std::size_t width_of(std::string_view text) {
  const auto begins_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return static_cast<std::size_t>(std::ranges::count_if(text, begins_letter));
}

inline std::string text_of(const matrix& m, std::string_view before, const plain_text_form& form) {
  std::vector<std::string> entries;
  std::vector<std::size_t> widths(static_cast<std::size_t>(m.columns));
  for (const expression& e : m.entries) {
    std::size_t& width = widths[entries.size() % widths.size()];
    entries.push_back(form.write(e.node()));
    if (form.is_cut_short()) return {};
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

} // namespace printing

KANEXPR_ENGINE std::string print(const matrix& m, std::string_view before, std::size_t longest) {
  if (m.entries.empty()) return std::string(before);
  const auto compose = [&](const printing::plain_text_form& form) {
    return printing::text_of(m, before, form);
  };
  return printing::write_within<printing::plain_text_form>(longest, m.entries[0].owner(), nodes_of(m.entries),
                                                           compose);
}
KANEXPR_ENGINE std::string print(const matrix& m, std::size_t longest) { return print(m, {}, longest); }

} // namespace kanexpr::symbolic
