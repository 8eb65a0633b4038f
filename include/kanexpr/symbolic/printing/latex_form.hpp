#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/printing/greek.hpp>
#include <kanexpr/symbolic/printing/latex.hpp>
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

/// Splits `theta12` into theta and 12, `I_xx` into I and xx, `Link<3>` into Link and 3.
struct name_parts {
  std::string head{};
  std::string subscript{};

  explicit name_parts(std::string_view name) {
    const auto begin = std::ranges::find_if_not(name, is_letter);
    head.assign(name.begin(), begin);
    bool is_apart = false;
    for (auto c = begin; c != name.end(); ++c) {
      const bool shows = is_letter(*c) || is_digit(*c);
      if (shows && is_apart && !subscript.empty()) subscript += ',';
      if (shows) subscript += *c;
      is_apart = !shows;
    }
    if (head.empty()) head.swap(subscript);
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  /// Bytes beyond ASCII belong to letters in UTF-8.
  static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  }
};

/// Writes a single letter, a Greek letter given by its name, or an upright word.
inline std::string latex_identifier(const std::string& word) {
  if (word.size() == 1) return word;
  return !greek_letter_called(word).empty() ? "\\" + word : "\\mathrm{" + word + "}";
}

/// Trailing primes, as in `theta''`, denote time derivatives and become dots.
inline std::string latex_name(std::string_view name, bool dotted = false) {
  std::size_t dots = dotted ? 1 : 0;
  for (; name.ends_with('\''); name.remove_suffix(1)) ++dots;
  const name_parts parts(name);
  std::string text = latex_identifier(parts.head);
  if (dots > 0) text = "\\" + std::string(dots, 'd') + "ot{" + text + "}";
  if (parts.subscript.empty()) return text;
  const bool is_number = std::ranges::all_of(parts.subscript, name_parts::is_digit);
  const std::string below = is_number ? parts.subscript : latex_identifier(parts.subscript);
  return text + "_" + (below.size() == 1 ? below : "{" + below + "}");
}

class latex_form : public writer<latex_form> {
public:
  using writer::writer;

  std::string product(const side& s) const {
    std::string text = s.shows_number() ? number_of(s.coefficient) : "";
    for (std::size_t i = 0; i < s.factors.size(); ++i) {
      const factor& f = s.factors[i];
      const bool ends_open = i + 1 == s.factors.size() || is_named(s.factors[i + 1].base);
      const std::string next =
          is_named(f.base) ? function(f.base, exponent_mark(f.exponent), ends_open) : text_of(f);
      const bool digits_meet = !text.empty() && next[0] >= '0' && next[0] <= '9';
      text += (text.empty() ? "" : digits_meet ? " \\cdot " : " ") + next;
    }
    return text;
  }
  std::string quotient(const side& above, const side& below) const {
    return "\\frac{" + fraction_side(above) + "}{" + fraction_side(below) + "}";
  }
  std::string function(int id) const { return function(id, "", true); }
  std::string conditional_of(const std::string& condition, const std::string& positive,
                             const std::string& other) const {
    return "\\operatorname{if}" + in_parentheses(condition + " > 0, " + positive + ", " + other);
  }
  std::string name_of(const symbol& s) const {
    const bool is_rate = s.kind == symbol_kind::coordinate_rate || s.kind == symbol_kind::speed_rate;
    return latex_name(s.called.view(), is_rate);
  }
  std::string name_of_part(const std::string& name) const { return latex_name(name); }
  std::string number_of(const number& n) const {
    std::string text = decimal(n);
    if (text == "inf") return "\\infty";
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    const std::string tens = "10^{" + std::to_string(std::stoi(text.substr(e + 1))) + "}";
    return text.substr(0, e) == "1" ? tens : text.substr(0, e) + " \\cdot " + tens;
  }
  std::string exponent(int id) const { return write(id); }
  std::string power(const std::string& base, const std::string& exponent) const {
    return base + "^{" + exponent + "}";
  }
  std::string raised(int base, const std::string& exponent) const {
    if (is_named(base)) return function(base, "^{" + exponent + "}", false);
    const std::string text = operand(base);
    const operation op = at(base).op;
    const bool is_power =
        (op == operation::exp || op == operation::constant) && text.find('^') != std::string::npos;
    return power(is_power && !text.starts_with("\\left(") ? in_parentheses(text) : text, exponent);
  }
  std::string in_parentheses(const std::string& text) const { return "\\left(" + text + "\\right)"; }

  /// Appends the definitions of parts to a formula, one per line.
  static std::string with_definitions(const std::string& text,
                                      const std::vector<text_with_parts::part>& parts) {
    std::string all = "\\begin{aligned}\n& " + text + " \\\\\n& \\text{where}";
    for (const text_with_parts::part& each : parts) all.append(" \\\\\n" + each.name + " &= " + each.text);
    return all + "\n\\end{aligned}";
  }

private:
  /// Whether a function is written as a name before its argument.
  bool is_named(int id) const {
    const operation op = at(id).op;
    return !is_part(id) && is_written_as_function(op) && op != operation::sqrt && op != operation::cbrt &&
           op != operation::abs && op != operation::exp && op != operation::component && !is_selection(op);
  }

  static std::string exponent_mark(std::int64_t exponent) {
    return exponent == 1 ? "" : "^{" + std::to_string(exponent) + "}";
  }

  static std::string word_for(operation op) {
    const std::string command = symbolic::is_function(op) ? properties_of(op).latex : "";
    return command.empty() ? std::string("\\operatorname{") + function_name(op) + "}" : command;
  }

  /// Writes a derivative with respect to the n-th operand as a prefix ∂_n.
  std::string name_of(const external_function& f, const std::string& mark) const {
    std::string text;
    for (int k = 0; k < f.order; ++k) text += "\\partial_{" + std::to_string(f.by[k] + 1) + "} ";
    text += latex_name(f.original.view(), false);
    return mark.empty() || f.order == 0 ? text + mark : in_parentheses(text) + mark;
  }

  /// `ends_open` means that nothing follows that could be read as part of the argument.
  std::string function(int id, const std::string& mark, bool ends_open) const {
    const node& n = at(id);
    if (n.op == operation::component) return component(n);
    if (is_solution(n.op)) return solution(n);
    if (n.op == operation::factorization) return brackets(rows_of(id, false));
    if (n.op == operation::singularity_measure) {
      const std::string of = is_part(n.a) ? reference(n.a) : brackets(rows_of(n.a, false));
      return "\\operatorname{singularity\\ measure}" + mark + in_parentheses(of);
    }
    if (is_selection(n.op)) return conditional(id);
    if (n.op == operation::call)
      return name_of(owner().external_at(id), mark) + in_parentheses(separated(elements(n.a)));
    const std::string argument = write(n.a);
    if (n.op == operation::sqrt || n.op == operation::cbrt) return word_for(n.op) + "{" + argument + "}";
    if (n.op == operation::abs) return "\\left|" + argument + "\\right|";
    if (n.op == operation::exp) return "e^{" + argument + "}";
    const std::string word = word_for(n.op) + mark;
    if (is_binary(n.op)) return word + in_parentheses(argument + ", " + write(n.b));
    if (is_one_name(n.a) && ends_open) return word + " " + argument;
    return word + in_parentheses(argument);
  }

  std::string component(const node& n) const {
    const std::string whole = is_part(n.a) ? reference(n.a) : solution(at(n.a));
    return in_parentheses(whole) + "_{" + std::to_string(integer_at(owner(), n.b) + 1) + "}";
  }
  std::string solution(const node& n) const {
    const bool transposed = n.op == operation::transposed_solve;
    const std::string inverse = !is_part(n.a) ? brackets(rows_of(n.a, transposed)) + "^{-1}"
                                              : reference(n.a) + (transposed ? "^{-\\mathsf{T}}" : "^{-1}");
    std::vector<std::vector<int>> right;
    for (int id : elements(n.b)) right.push_back({id});
    return inverse + " " + brackets(right);
  }
  std::string brackets(const std::vector<std::vector<int>>& rows) const {
    std::string text = "\\begin{bmatrix}";
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j)
        text += (j > 0 ? " & " : i > 0 ? " \\\\ " : " ") + write(rows[i][j]);
    return text + " \\end{bmatrix}";
  }

  /// Writes one side of a fraction; the fraction bar makes parentheses unnecessary.
  std::string fraction_side(const side& s) const {
    const bool is_bare = !s.shows_number() && s.factors.size() == 1 && s.factors[0].exponent == 1;
    return is_bare ? write(s.factors[0].base) : product(s);
  }
};

inline std::string text_of(const matrix& m, const latex_form& form) {
  std::string text = "\\begin{bmatrix}\n";
  for (int i = 0; i < m.rows; ++i)
    for (int j = 0; j < m.columns; ++j)
      text += form.write(m(i, j).node()) + (j + 1 < m.columns ? " & " : i + 1 < m.rows ? " \\\\\n" : "\n");
  return text + "\\end{bmatrix}";
}

} // namespace printing

KANEXPR_ENGINE std::string latex(const graph& g, int id, std::size_t longest) {
  const auto compose = [id](const printing::latex_form& form) { return form.write(id); };
  return printing::write_within<printing::latex_form>(longest, g, {id}, compose);
}
KANEXPR_ENGINE std::string latex(expression e, std::size_t longest) {
  return latex(e.owner(), e.node(), longest);
}
KANEXPR_ENGINE text_with_parts latex_each(const sequence<expression>& all, std::size_t longest) {
  return printing::write_each<printing::latex_form>(longest, all);
}
KANEXPR_ENGINE std::string latex(const matrix& m, std::size_t longest) {
  if (m.entries.empty()) return "\\begin{bmatrix}\n\\end{bmatrix}";
  const auto compose = [&m](const printing::latex_form& form) { return printing::text_of(m, form); };
  return printing::write_within<printing::latex_form>(longest, m.entries[0].owner(), nodes_of(m.entries),
                                                      compose);
}

} // namespace kanexpr::symbolic
