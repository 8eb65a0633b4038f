#pragma once

#include <kanexpr/symbolic/block_triangular.hpp>
#include <kanexpr/symbolic/linear_system.hpp>

namespace kanexpr::symbolic {

/// One coupled part of a linear system that is solved on its own and may be singular at some states.
struct solved_block {
  sequence<int> rows, columns; ///< equations and unknowns
  int key = 0;                 ///< the divisor where there is one unknown, else the factorization
  expression regularity;       ///< far from singular up to 1, singular 0
};

struct linear_solution {
  matrix x;
  sequence<solved_block> blocks; ///< not those whose matrix is of numbers
  bool structurally_regular = true;
};

/// Whether nodes that are needed rest on the solution of a block.
constexpr bool rests_on(const graph& g, const sequence<char>& live, int key) {
  if (g[key].op == operation::factorization) return live[key] != 0;
  for (int id = key + 1; id < live.size(); ++id)
    if (live[id] != 0 && g[id].op == operation::divide && g[id].b == key) return true;
  return false;
}

namespace detail {

class linear_solver {
public:
  constexpr linear_solver(graph& g, const matrix& a, const matrix& b, const sequence<expression>& scales)
      : g_(g), a_(a), b_(b), scales_(scales), is_solved_(a.columns, 0) {
    out_.x = matrix(g, a.rows, b.columns);
  }

  constexpr const linear_solution& run() {
    sequence<char> is_used(a_.rows, 0);
    for (bool progress = true; progress;) {
      progress = false;
      for (int i = 0; i < a_.rows; ++i) {
        const int j = is_used[i] != 0 ? none : only_unknown(i);
        if (j == none) continue;
        divide(i, j);
        is_used[i] = is_solved_[j] = 1;
        progress = true;
      }
    }
    sequence<int> rows, columns;
    for (int i = 0; i < a_.rows; ++i)
      if (is_used[i] == 0) rows.push(i);
    for (int j = 0; j < a_.columns; ++j)
      if (is_solved_[j] == 0) columns.push(j);
    if (!rows.empty()) solve_coupled(rows, columns);
    return out_;
  }

private:
  static constexpr int none = -1;

  constexpr int only_unknown(int i) const {
    int only = none;
    for (int j = 0; j < a_.columns; ++j) {
      if (is_solved_[j] != 0 || a_(i, j).is_zero()) continue;
      if (only != none) return none;
      only = j;
    }
    return only;
  }

  constexpr void solve_coupled(const sequence<int>& rows, const sequence<int>& columns) {
    sequence<sequence<int>> held;
    for (int i : rows) {
      held.push({});
      for (int j = 0; j < columns.size(); ++j)
        if (!a_(i, columns[j]).is_zero()) held.back().push(j);
    }
    const block_triangular_form form(held);
    out_.structurally_regular = form.is_regular();
    for (coupled_part part : form.parts()) {
      for (int& i : part.rows) i = rows[i];
      for (int& j : part.columns) j = columns[j];
      if (!is_ready(part)) continue;
      if (part.rows.size() == 1)
        divide(part.rows[0], part.columns[0]);
      else
        solve(part);
      for (int j : part.columns) is_solved_[j] = 1;
    }
  }

  constexpr bool is_ready(const coupled_part& part) const {
    for (int i : part.rows)
      for (int j = 0; j < a_.columns; ++j)
        if (!a_(i, j).is_zero() && is_solved_[j] == 0 && !part.columns.contains(j)) return false;
    return true;
  }

  /// What equation i leaves on the right for the unknowns of its own part.
  constexpr expression right_side(int i, int column) const {
    expression sum = b_(i, column);
    for (int j = 0; j < a_.columns; ++j)
      if (is_solved_[j] != 0 && !a_(i, j).is_zero()) sum -= a_(i, j) * out_.x(j, column);
    return sum;
  }

  constexpr expression scale_of(int i) const {
    if (!scales_.empty()) return scales_[i];
    expression sum{g_, graph::zero};
    for (int j = 0; j < a_.columns; ++j) sum += abs(a_(i, j));
    return sum;
  }

  /// One reciprocal is cheaper than several divisions.
  constexpr void divide(int i, int j) {
    const expression divisor = a_(i, j);
    sequence<expression> right;
    int used = 0;
    for (int column = 0; column < b_.columns; ++column) {
      right.push(right_side(i, column));
      if (!right.back().is_zero()) ++used;
    }
    const expression reciprocal = used > 1 ? 1 / divisor : divisor;
    for (int column = 0; column < b_.columns; ++column)
      out_.x(j, column) = used > 1 ? right[column] * reciprocal : right[column] / divisor;
    if (divisor.is_constant()) return;
    int key = without_sign(divisor.node());
    if (used > 1) {
      const int quotient = without_sign(reciprocal.node());
      if (g_[quotient].op != operation::divide) return; // the divisor is one part of something
      key = g_[quotient].b;
    }
    out_.blocks.push({{i}, {j}, key, abs(divisor) / expression{g_, positive_or_one(g_, scale_of(i).node())}});
  }

  constexpr int without_sign(int id) const { return g_[id].op == operation::negate ? g_[id].a : id; }

  constexpr void solve(const coupled_part& part) {
    const int order = part.rows.size();
    matrix a(g_, order, order);
    sequence<expression> scales;
    bool is_constant = true;
    for (int i = 0; i < order; ++i) {
      scales.push(scale_of(part.rows[i]));
      for (int j = 0; j < order; ++j) {
        a(i, j) = a_(part.rows[i], part.columns[j]);
        is_constant = is_constant && a(i, j).is_constant();
      }
    }
    const expression factors = factorization(g_, a);
    for (int column = 0; column < b_.columns; ++column) {
      sequence<expression> right;
      for (int i : part.rows) right.push(right_side(i, column));
      const sequence<expression> x = symbolic::solve(factors, right);
      for (int j = 0; j < order; ++j) out_.x(part.columns[j], column) = x[j];
    }
    if (is_constant && !constant_inverse(g_, factors.node()).empty()) return;
    out_.blocks.push({part.rows, part.columns, factors.node(), regularity(factors, scales)});
  }

  graph& g_;
  const matrix& a_;
  const matrix& b_;
  const sequence<expression>& scales_;
  sequence<char> is_solved_; ///< by column
  linear_solution out_;
};

} // namespace detail

/// Solves A X = B, where A is square and may have zeros: block by block of its block triangular form, so an
/// equation with one unknown left is a division. `scales` says how large the entries of each row are with
/// which its block is compared; without them, it is the sum of their magnitudes. Unknowns that a structurally
/// singular matrix leaves open stay zero.
constexpr linear_solution solve_linear(graph& g, const matrix& a, const matrix& b,
                                       const sequence<expression>& scales) {
  return detail::linear_solver(g, a, b, scales).run();
}

} // namespace kanexpr::symbolic
