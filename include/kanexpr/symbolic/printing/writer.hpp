#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>
#include <kanexpr/symbolic/printing/term.hpp>

#include <charconv>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::printing {

/// Builds the text of a sum: terms joined by their signs.
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

/// The shortest decimal text that reads back as the same number; fractions appear only as quotients of
/// integers.
inline std::string decimal(const number& n) {
  char buffer[32];
  const std::to_chars_result end = n.exact() ? std::to_chars(buffer, buffer + sizeof buffer, n.numerator)
                                             : std::to_chars(buffer, buffer + sizeof buffer, n.real);
  return {buffer, end.ptr};
}

/// The traversal shared by all printed forms. A form provides the text of the `product` of a side, the
/// `quotient` of two sides, a `function`, a symbol (`name_of`), a number (`number_of`), the `exponent` of a
/// node, the `power` of two strings, a condition with two branches (`conditional_of`), a node with an
/// exponent (`raised`), a text `in_parentheses`, the `name_of_part`, and a text `with_definitions` of parts.
template <class Form>
class writer {
public:
  static constexpr std::size_t any_length = static_cast<std::size_t>(-1);

  /// Stops writing when the text is longer than `longest`, or nested so deeply that the stack could
  /// overflow. Refers to `parts` by their names.
  explicit writer(const graph& g, std::size_t longest = any_length, const named_parts* parts = nullptr)
      : graph_(g), parts_(parts), reader_(g, parts), longest_(longest) {}
  writer(const writer&) = delete;
  writer& operator=(const writer&) = delete;

  std::string write(int id) const { return sum(reader_.terms_of(id)); }

  /// Whether a text is too long and therefore not complete.
  bool is_cut_short() const { return is_cut_short_; }

  /// The text of a part.
  std::string definition(int id) const {
    const node& n = at(id);
    if (n.op == operation::power) return form().raised(n.a, form().exponent(n.b));
    return is_written_as_function(n.op) ? form().function(id) : sum(reader_.definition_of(id));
  }
  /// The name of a part.
  std::string reference(int id) const { return form().name_of_part(parts_->name(id)); }

  /// The parts to which the text of a node refers, in reading order.
  std::vector<int> parts_of(int id) const {
    std::vector<int> found;
    find_parts(id, found);
    return found;
  }
  /// The parts to which the definition of a part refers.
  std::vector<int> parts_of_definition(int id) const {
    std::vector<int> found;
    find_parts_of_definition(id, found);
    return found;
  }

  std::string sum(const std::vector<term>& terms) const {
    terms_written_ += terms.size(); // each takes at least one character besides those of the terms in it
    if (longest_ != any_length && (terms_written_ > longest_ || depth_ > most_levels)) is_cut_short_ = true;
    if (is_cut_short_) return {};
    ++depth_;
    sum_text text;
    std::vector<bool> is_written(terms.size());
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (is_written[i]) continue;
      const std::size_t other = other_branch(terms, i);
      if (other < terms.size()) {
        is_written[other] = true;
        text.add(false, conditional(terms[i], terms[other]));
      } else {
        text.add(terms[i].coefficient.negative(), unsigned_text(terms[i]));
      }
    }
    --depth_;
    return text.text();
  }

  /// A term without its sign.
  std::string unsigned_text(const term& t) const {
    const side below = denominator(t);
    return below.is_one() ? form().product(numerator(t)) : form().quotient(numerator(t), below);
  }

  /// A factor of a larger product; the sign is extracted from a sum of negative terms.
  std::pair<bool, std::string> signed_factor(int id) const {
    std::vector<term> terms = reader_.terms_of(id);
    const bool negative = terms.front().coefficient.negative();
    if (terms.size() == 1) return {negative, unsigned_text(terms.front())};
    if (is_conditional(terms)) return {false, sum(terms)};
    if (negative)
      for (term& t : terms) t.coefficient = -t.coefficient;
    return {negative, form().in_parentheses(sum(terms))};
  }

protected:
  /// The text of a node, in parentheses if it needs them to take an exponent.
  std::string operand(int id) const {
    if (is_part(id)) return reference(id);
    const node& n = at(id);
    if (n.op == operation::symbol) return form().name_of(graph_.symbol_at(id));
    if (n.op == operation::constant) {
      const number& value = graph_.number_at(id);
      const bool whole = !value.negative() && (!value.exact() || value.integer());
      if (whole) return form().number_of(value);
    }
    if (is_written_as_function(n.op)) return form().function(id);
    const std::vector<term>& terms = reader_.terms_of(id);
    return is_conditional(terms) ? sum(terms) : form().in_parentheses(sum(terms));
  }

  std::string text_of(const factor& f) const {
    const node& n = at(f.base);
    if (n.op == operation::power && !is_part(f.base)) {
      std::string inner = form().raised(n.a, form().exponent(n.b));
      if (f.exponent == 1) return inner;
      return form().power(form().in_parentheses(inner), std::to_string(f.exponent));
    }
    return f.exponent == 1 ? operand(f.base) : form().raised(f.base, std::to_string(f.exponent));
  }

  /// The rows of a factorized matrix or of its transpose, as nodes.
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

  /// Joins expressions with commas.
  std::string separated(const std::vector<int>& nodes) const {
    std::string text;
    for (int id : nodes) text += (text.empty() ? "" : ", ") + write(id);
    return text;
  }

  /// The text of a single selection, whose other branch is zero.
  std::string conditional(int id) const {
    const std::string branch = write(at(id).b);
    return conditional(id, branch, "0");
  }

  const graph& owner() const { return graph_; }
  const node& at(int id) const { return graph_[id]; }
  bool is_part(int id) const { return reader_.is_part(id); }
  /// Whether a node is written as a symbol or as the name of a part.
  bool is_one_name(int id) const { return at(id).op == operation::symbol || is_part(id); }

private:
  void find_parts(int id, std::vector<int>& found) const {
    if (is_part(id))
      found.push_back(id);
    else
      find_parts_of_definition(id, found);
  }
  void find_parts_of_definition(int id, std::vector<int>& found) const {
    const node& n = at(id);
    if (is_leaf(n.op)) return;
    if (is_written_as_function(n.op) || n.op == operation::power) {
      find_parts(n.a, found);
      if (is_binary(n.op) && is_value(n)) find_parts(n.b, found);
      return;
    }
    for (const term& t : reader_.definition_of(id))
      for (const bool is_above : {true, false})
        for (const factor& f : t.factors)
          if ((f.exponent > 0) == is_above) find_parts(f.base, found);
  }

  static constexpr int most_levels = 300; ///< of nested sums

  /// The selection node of a term that consists of a selection and a coefficient, or -1.
  int selection_in(const term& t) const {
    const bool is_one = t.factors.size() == 1 && t.factors[0].exponent == 1;
    if (!is_one || is_part(t.factors[0].base)) return -1;
    return is_selection(at(t.factors[0].base).op) ? t.factors[0].base : -1;
  }
  /// The index of the first term after term i that is the other branch of the same condition, or
  /// `terms.size()` if there is none.
  std::size_t other_branch(const std::vector<term>& terms, std::size_t i) const {
    const int one = selection_in(terms[i]);
    std::size_t k = one < 0 ? terms.size() : i + 1;
    for (; k < terms.size(); ++k)
      if (const int other = selection_in(terms[k]); other >= 0)
        if (at(other).a == at(one).a && at(other).op != at(one).op) break;
    return k;
  }
  bool is_conditional(const std::vector<term>& terms) const {
    return terms.size() == 2 && other_branch(terms, 0) == 1;
  }
  std::string conditional(const term& one, const term& other) const {
    const auto branch = [this](const term& t) {
      std::vector<term> terms = reader_.terms_of(at(selection_in(t)).b);
      for (term& each : terms) each.coefficient = each.coefficient * t.coefficient;
      return sum(terms);
    };
    return conditional(selection_in(one), branch(one), branch(other));
  }
  std::string conditional(int id, const std::string& branch, const std::string& other) const {
    const bool is_first = at(id).op == operation::if_positive;
    return form().conditional_of(write(at(id).a), is_first ? branch : other, is_first ? other : branch);
  }

  const Form& form() const { return static_cast<const Form&>(*this); }

  const graph& graph_;
  const named_parts* parts_;
  mutable term_reader reader_; // caches its results
  std::size_t longest_;
  mutable std::size_t terms_written_ = 0;
  mutable int depth_ = 0;
  mutable bool is_cut_short_ = false;
};

} // namespace kanexpr::symbolic::printing
