#pragma once

#include <kanexpr/symbolic/linear/solve.hpp>
#include <kanexpr/symbolic/print/term.hpp>

#include <charconv>
#include <string>

namespace kanexpr::symbolic::printing {

/// A sum in the making: terms joined by their signs.
class sum_text {
public:
  void add(bool negative, const std::string& term) {
    if (text_.empty())
      text_ = negative ? "-" : "";
    else
      text_ += negative ? " - " : " + ";
    text_ += term;
  }
  std::string text() const { return text_.empty() ? "0" : text_; }

private:
  std::string text_{};
};

/// The shortest decimal text that reads back as the same number; fractions only occur as quotients of
/// integers.
inline std::string decimal(const number& n) {
  char buffer[32];
  const std::to_chars_result end = n.exact() ? std::to_chars(buffer, buffer + sizeof buffer, n.numerator)
                                             : std::to_chars(buffer, buffer + sizeof buffer, n.real);
  return {buffer, end.ptr};
}

/// The walk that all printed forms share. A form provides `product` of a side and `quotient`
/// of two, texts of a `function`, `name_of` a symbol and `number_of` a number, `exponent` of a node, `power`
/// of two texts, `raised` for a node and an exponent's text, and `in_parentheses`.
template <class Form>
class writer {
public:
  explicit writer(const graph& g) : graph_(g), reader_(g) {}

  std::string write(int id) const { return sum(reader_.terms_of(id)); }

  std::string sum(const std::vector<term>& terms) const {
    sum_text text;
    for (const term& t : terms) text.add(t.coefficient.negative(), unsigned_text(t));
    return text.text();
  }

  /// A term without its sign.
  std::string unsigned_text(const term& t) const {
    const side below = denominator(t);
    return below.is_one() ? form().product(numerator(t)) : form().quotient(numerator(t), below);
  }

  /// A factor of something larger, with the sign that it takes out of a sum of negative terms.
  std::pair<bool, std::string> signed_factor(int id) const {
    std::vector<term> terms = reader_.terms_of(id);
    const bool negative = terms.front().coefficient.negative();
    if (terms.size() == 1) return {negative, unsigned_text(terms.front())};
    if (negative)
      for (term& t : terms) t.coefficient = -t.coefficient;
    return {negative, form().in_parentheses(sum(terms))};
  }

protected:
  /// The text of a node that stays whole under an exponent.
  std::string operand(int id) const {
    const node& n = at(id);
    if (n.op == operation::symbol) return form().name_of(graph_.symbol_at(id));
    if (n.op == operation::constant) {
      const number& value = graph_.number_at(id);
      const bool whole = !value.negative() && (!value.exact() || value.integer());
      if (whole) return form().number_of(value);
    }
    if (is_written_as_function(n.op)) return form().function(id);
    return form().in_parentheses(write(id));
  }

  std::string text_of(const factor& f) const {
    const node& n = at(f.base);
    if (n.op == operation::power) {
      std::string inner = form().raised(n.a, form().exponent(n.b));
      if (f.exponent == 1) return inner;
      return form().power(form().in_parentheses(inner), std::to_string(f.exponent));
    }
    return f.exponent == 1 ? operand(f.base) : form().raised(f.base, std::to_string(f.exponent));
  }

  /// The rows of a factorized matrix, or their transpose, as nodes.
  std::vector<std::vector<int>> rows_of(int factorization, bool transposed) const {
    const sequence<int> entries = entries_of(graph_, factorization);
    const int order = order_of(graph_, factorization);
    std::vector<std::vector<int>> rows(static_cast<std::size_t>(order));
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j)
        rows[static_cast<std::size_t>(i)].push_back(entries[transposed ? j * order + i : i * order + j]);
    return rows;
  }
  std::vector<int> elements(int list) const {
    const sequence<int> all = elements_of(graph_, list);
    return {all.begin(), all.end()};
  }

  const graph& owner() const { return graph_; }
  const node& at(int id) const { return graph_[id]; }

private:
  const Form& form() const { return static_cast<const Form&>(*this); }

  const graph& graph_;
  mutable term_reader reader_; // remembers
};

} // namespace kanexpr::symbolic::printing
