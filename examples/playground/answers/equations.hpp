#pragma once

#include "playground/session.hpp"

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/symbolic/algebra/simplify.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/printing/latex.hpp>
#include <kanexpr/symbolic/printing/text_with_parts.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>

namespace playground {

/// A matrix in LaTeX, entry by entry and simplified, or only its size and its number of operations if it is
/// too long to be read.
inline nlohmann::json matrix_in_latex(const kanexpr::symbolic::matrix& m) {
  constexpr int longest_entry = 160, longest = 900;
  constexpr std::size_t most_terms = 120;
  nlohmann::json written{{"rows", m.rows}, {"columns", m.columns}};
  int operations = 0;
  bool is_long = false;
  for (const auto& e : m.entries) {
    const int each = kanexpr::symbolic::detail::operations(e);
    operations += each;
    is_long = is_long || each > longest_entry;
  }
  if (is_long || operations > longest) {
    written["operations"] = operations;
    return written;
  }
  kanexpr::base::sequence<kanexpr::symbolic::expression> simplified;
  for (const auto& e : m.entries) simplified.push(kanexpr::symbolic::simplify(e, most_terms));
  const kanexpr::symbolic::text_with_parts text = kanexpr::symbolic::latex_each(simplified);
  if (text.parts.empty())
    written["entries"] = text.expressions;
  else // few operations, but a text that repeats them too often
    written["operations"] = operations;
  return written;
}

/// A matrix of numbers at the state of this moment.
inline nlohmann::json matrix_in_numbers(session& of, const kanexpr::symbolic::matrix& m) {
  const moving_model& at = of.moving();
  auto function = of.model().function(m);
  const auto& found = function(at.t, at.x, at.p, at.r);
  nlohmann::json written{{"rows", m.rows}, {"columns", m.columns}};
  nlohmann::json& entries = written["entries"] = nlohmann::json::array();
  for (Eigen::Index i = 0; i < found.size(); ++i) entries.push_back(found(i / m.columns, i % m.columns));
  return written;
}

/// The state of this moment as an operating point; speeds and coordinates that are nearly whole numbers are
/// exact.
inline kanexpr::linearization_point point_of(const moving_model& at) {
  constexpr double close = 1e-9;
  kanexpr::linearization_point point;
  for (int i = 0; i < at.states(); ++i) {
    const double value = at.x(i), whole = std::round(value);
    if (at.known().dependent[i] && i >= at.coordinates()) continue; // follows from the constraints
    const auto called = at.known().names[i].view();
    if (std::abs(value - whole) < close)
      point.set(called, static_cast<int>(whole));
    else
      point.set(called, value);
  }
  return point;
}

/// What the entries of a matrix show.
enum class entries : int { symbols, numbers, symbols_at_state };

/// M and f, or A and B.
inline nlohmann::json equations(session& of, bool are_linearized, entries shown) {
  using kanexpr::mechanics::quantity;
  const auto answer = [&](quantity wanted) {
    const kanexpr::symbolic::matrix m = of.model().get(wanted);
    return shown == entries::numbers ? matrix_in_numbers(of, m) : matrix_in_latex(m);
  };
  if (!are_linearized) return {{"M", answer(quantity::mass_matrix)}, {"f", answer(quantity::forcing)}};
  if (shown != entries::symbols_at_state)
    return {{"A", answer(quantity::state_matrix)}, {"B", answer(quantity::input_matrix)}};
  auto linear = of.model().linearize(point_of(of.moving()));
  const auto matrices = linear.explicit_form();
  if (!linear.failures().empty()) return {{"mistake", linear.failures().front()}};
  return {{"A", matrix_in_latex(matrices.A)}, {"B", matrix_in_latex(matrices.B)}};
}

} // namespace playground
