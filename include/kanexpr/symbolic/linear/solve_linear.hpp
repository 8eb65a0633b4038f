#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/block_triangular.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>
#include <kanexpr/symbolic/sizes/mean_square.hpp>

namespace kanexpr::symbolic {

/// One coupled block of a linear system, which is solved separately and may be singular at some states.
struct solved_block {
  sequence<int> rows{}, columns{}; ///< equations and unknowns
  int key = 0;                     ///< the divisor if there is one unknown, otherwise the factorization
  expression measure{}; ///< 0 if the block is singular; up to sign, about `scale` if it is far from singular
  expression scale{};
};

struct linear_solution {
  matrix x{};
  sequence<solved_block> blocks{}; ///< except blocks with a constant matrix
  bool structurally_regular = true;
};

/// Whether live nodes depend on the solution of a block.
constexpr bool depends_on_block(const graph& g, const base::zeros<char>& live, int key) {
  if (g[key].op == operation::factorization) return live[key] != 0;
  for (int id = key + 1; id < live.size(); ++id)
    if (live[id] != 0 && g[id].op == operation::divide && g[id].b == key) return true;
  return false;
}

namespace detail {

class linear_solver {
public:
  constexpr linear_solver(graph& g, const matrix& a, const matrix& b, const matrix& equations,
                          const sequence<int>& sums)
      : g_(g), a_(a), b_(b), equations_(equations), sums_(sums), is_solved_(a.columns, 0) {
    out_.x = matrix(g, a.rows, b.columns);
  }

  constexpr const linear_solution& run() {
    sequence<char> is_used(a_.rows, 0);
    for (bool progress = true; progress;) {
      progress = false;
      for (int i = 0; i < a_.rows; ++i) {
        const int j = is_used[i] != 0 ? none : single_unknown(i);
        if (j == none) continue;
        divide(i, j);
        is_used[i] = is_solved_[j] = 1;
        progress = true;
      }
    }
    sequence<int> rows{}, columns{};
    for (int i = 0; i < a_.rows; ++i)
      if (is_used[i] == 0) rows.push(i);
    for (int j = 0; j < a_.columns; ++j)
      if (is_solved_[j] == 0) columns.push(j);
    if (!rows.empty()) solve_coupled(rows, columns);
    return out_;
  }

private:
  static constexpr int none = -1;

  constexpr int single_unknown(int i) const {
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
    for (diagonal_block part : form.parts()) {
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

  constexpr bool is_ready(const diagonal_block& part) const {
    for (int i : part.rows)
      for (int j = 0; j < a_.columns; ++j)
        if (!a_(i, j).is_zero() && is_solved_[j] == 0 && !part.columns.contains(j)) return false;
    return true;
  }

  /// The right-hand side of equation i for the unknowns of its own block.
  constexpr expression right_side(int i, int column) const {
    expression sum = b_(i, column);
    for (int j = 0; j < a_.columns; ++j)
      if (is_solved_[j] != 0 && !a_(i, j).is_zero()) sum -= a_(i, j) * out_.x(j, column);
    return sum;
  }

  /// The mean squares of the entries of a block, row by row.
  constexpr sequence<int> squares_of(const sequence<int>& rows, const sequence<int>& columns) const {
    sequence<int> coefficients, entries, squares;
    for (int i : rows) {
      for (int j = 0; j < equations_.columns; ++j) coefficients.push(equations_(i, j).node());
      for (int j : columns) entries.push(a_(i, j).node());
    }
    const mean_square of(g_, coefficients, entries, sums_);
    for (int id : entries) squares.push(of[id]);
    return squares;
  }

  constexpr expression root(int square) const { return sqrt(expression{g_, square}); }

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
      if (g_[quotient].op != operation::divide) return; // the divisor is only part of the denominator
      key = g_[quotient].b;
    }
    out_.blocks.push({{i}, {j}, key, divisor, root(squares_of({i}, {j})[0])});
  }

  constexpr int without_sign(int id) const { return g_[id].op == operation::negate ? g_[id].a : id; }

  constexpr void solve(const diagonal_block& part) {
    const int order = part.rows.size();
    matrix a(g_, order, order);
    bool is_constant = true;
    for (int i = 0; i < order; ++i) {
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
    push_block(part, factors);
  }

  /// A small block uses the mean square of its determinant. For a larger block, each pivot is compared with
  /// the mean square that elimination forms from the mean squares of the entries.
  constexpr void push_block(const diagonal_block& part, expression factors) {
    const int order = part.rows.size();
    const sequence<int> squares = squares_of(part.rows, part.columns);
    const expression one{g_, graph::one};
    if (order <= max_cofactor_order) {
      out_.blocks.push({part.rows, part.columns, factors.node(), singularity_measure(factors, {}),
                        root(permanent(g_, squares, order))});
      return;
    }
    sequence<expression> sizes;
    for (int id : squares) sizes.push({g_, id});
    out_.blocks.push({part.rows, part.columns, factors.node(), singularity_measure(factors, sizes), one});
  }

  graph& g_;
  const matrix& a_;
  const matrix& b_;
  const matrix& equations_;
  const sequence<int>& sums_;
  sequence<char> is_solved_; ///< by column
  linear_solution out_{};
};

} // namespace detail

/// Solves A X = B for a square A, which may be sparse, block by block in block triangular form; an equation
/// with one remaining unknown is a division. `equations` has one row per equation with all coefficients,
/// including those of variables that are not unknowns here; `sums` are the sums from which the equations were
/// formed; all terms of a sum have the same unit. Unknowns that a structurally singular matrix leaves
/// undetermined remain zero.
constexpr linear_solution solve_linear(graph& g, const matrix& a, const matrix& b, const matrix& equations,
                                       const sequence<int>& sums = {}) {
  return detail::linear_solver(g, a, b, equations, sums).run();
}

constexpr linear_solution solve_linear(graph& g, const matrix& a, const matrix& b) {
  return solve_linear(g, a, b, a);
}

} // namespace kanexpr::symbolic
