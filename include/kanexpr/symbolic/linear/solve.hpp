#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/list.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/monomials.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/column_groups.hpp>
#include <kanexpr/symbolic/linear/solve_linear.hpp>
#include <kanexpr/symbolic/linear/symmetric_columns.hpp>

namespace kanexpr::symbolic {

/// The divisor for one unknown in the elimination of a symmetric matrix.
struct pivot {
  int place = 0; ///< index of the unknown
  int key = 0;   ///< the divisor
  expression value{};
  expression entry{}; ///< the diagonal entry before elimination
};

struct symmetric_solution {
  sequence<expression> x{};
  sequence<pivot> pivots{}; ///< constants are omitted; a pivot precedes those that depend on it
};

/// Records the pivot that a quotient divides by. If the quotient was simplified, its divisor is only a factor
/// of the pivot; the divisor is then compared with itself.
constexpr void record_pivot(sequence<pivot>& all, int place, expression quotient, expression value,
                            expression entry) {
  graph& g = value.owner();
  const auto unsigned_node = [&](int id) { return g[id].op == operation::negate ? g[id].a : id; };
  const node& divided = g[unsigned_node(quotient.node())];
  if (value.is_constant() || divided.op != operation::divide) return;
  if (divided.b == unsigned_node(value.node()))
    all.push({place, divided.b, value, entry});
  else
    all.push({place, divided.b, {g, divided.b}, {g, divided.b}});
}

namespace detail {

/// A symmetric matrix during elimination, with nodes in both triangles, and the number of off-diagonal
/// entries in each remaining row. It uses plain arrays because compilers interpret every call.
struct symmetric_elimination {
  int n;
  sequence<int> entries;
  sequence<int> row_degrees;
  int* entry;  ///< entries in row-major order
  int* degree; ///< number of off-diagonal entries in each row

  /// Reads the lower triangle.
  constexpr explicit symmetric_elimination(const matrix& m)
      : n(m.rows), entries(n * n, graph::zero), row_degrees(n, 0), entry(entries.begin()),
        degree(row_degrees.begin()) {
    const expression* const given = m.entries.begin();
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j) {
        const int id = given[i * n + j].node();
        entry[i * n + j] = entry[j * n + i] = id;
        if (id != graph::zero && i != j) ++degree[i], ++degree[j];
      }
  }
  symmetric_elimination(const symmetric_elimination&) = delete;
  symmetric_elimination& operator=(const symmetric_elimination&) = delete;

  constexpr void set(int i, int j, int id) {
    const bool was = entry[i * n + j] != graph::zero, is = id != graph::zero;
    entry[i * n + j] = entry[j * n + i] = id;
    if (i == j || was == is) return;
    const int change = is ? 1 : -1;
    degree[i] += change, degree[j] += change;
  }

  /// The remaining row with the fewest entries, given the positions of the others in the elimination order.
  constexpr int next(const sequence<int>& positions) const {
    int p = -1, least = n + 1;
    for (int i = n - 1; i >= 0; --i)
      if (positions[i] < 0 && degree[i] < least) p = i, least = degree[i];
    return p;
  }
};

} // namespace detail

/// Factorizes a symmetric positive definite matrix as M = LᵀDL, without square roots, to solve M x = f.
///
/// The elimination order preserves structural zeros: it is the minimum-degree order, with ties resolved in
/// favor of the last row, so that a chain is eliminated from tip to base. Only the lower triangle of M is
/// read.
class symmetric_factorization {
public:
  constexpr symmetric_factorization(graph& g, const matrix& m)
      : g_(g), n_(m.rows), left_(m), inverses_(n_, graph::zero), factors_(n_ * n_, graph::zero),
        positions_(n_, none) {
    for (int i = 0; i < n_; ++i) diagonal_.push(m(i, i));
    while (order_.size() < n_) eliminate(left_.next(positions_));
  }
  symmetric_factorization(const symmetric_factorization&) = delete;
  symmetric_factorization& operator=(const symmetric_factorization&) = delete;

  /// Prepares for many right-hand sides, the columns of a matrix. Where the right-hand sides of a whole
  /// branch are zero, as those of one leg if the joints of another leg move, its unknowns follow from those
  /// outside of the branch. These dependencies are formed where they save operations in all columns together.
  constexpr void prepare_for(const matrix& right) {
    sequence<char> filled(n_ * right.columns, 1); // whether an entry is nonzero once it is reduced
    sequence<int> weights(right.columns, 0);
    bool has_zeros = false;
    const expression* const entries = right.entries.begin();
    const int* const factors = factors_.begin();
    for (int j = 0; j < right.columns; ++j) {
      const int column = j * n_;
      char* const of = filled.begin() + column;
      int count = 0;
      for (int i = 0; i < n_; ++i) {
        of[i] = entries[i * right.columns + j].node() == graph::zero ? 0 : 1;
        count += of[i];
      }
      // nothing to do, a column of the inverse, of which half follows by symmetry, or a whole column
      weights[j] = count < 2 ? count : 2;
      if (count == n_) continue;
      for (int p : order_)
        for (int i = 0; i < n_ && of[p] != 0; ++i)
          if (factors[p * n_ + i] != graph::zero) of[i] = 1;
      for (int i = 0; i < n_; ++i) has_zeros = has_zeros || (weights[j] == 2 && of[i] == 0);
    }
    if (!has_zeros) return;
    is_within_ = sequence<char>(n_ * n_, 0);
    responses_ = factors_;
    for (int step = n_ - 1; step >= 0; --step) respond(order_[step], filled, weights);
  }

  constexpr symmetric_solution solve(const sequence<expression>& f) const {
    symmetric_solution solved;
    solved.pivots = pivots_;
    sequence<int> right = nodes_of(f), x(n_, graph::zero);
    reduce(right);
    for (int step = n_ - 1; step >= 0; --step) x[order_[step]] = unknown(step, right, x, solved.pivots);
    for (int id : x) solved.x.push({g_, id});
    return solved;
  }

  /// Returns selected columns of the inverse. It is symmetric, so only one of two equal entries is computed.
  /// Each column is stored with its pivots, as a solution is.
  constexpr sequence<symmetric_solution> inverse_columns(const sequence<int>& columns) const {
    sequence<symmetric_solution> solved(columns.size());
    sequence<sequence<int>> right, x;
    for (int i = 0; i < columns.size(); ++i) {
      right.push(sequence<int>(n_, graph::zero));
      x.push(sequence<int>(n_, graph::zero));
      right[i][columns[i]] = graph::one;
      reduce(right[i]);
      solved[i].pivots = pivots_;
      for (int step = n_ - 1; step >= positions_[columns[i]]; --step)
        x[i][order_[step]] = unknown(step, right[i], x[i], solved[i].pivots);
    }
    for (int i = 0; i < columns.size(); ++i) {
      for (int step = positions_[columns[i]] - 1; step >= 0; --step) {
        const int p = order_[step], mirrored = columns.find(p);
        x[i][p] = mirrored >= 0 ? x[mirrored][columns[i]] : unknown(step, right[i], x[i], solved[i].pivots);
      }
      for (int id : x[i]) solved[i].x.push({g_, id});
    }
    return solved;
  }

  /// Solves for several columns of `right` into the same columns of `x`, as one node for all columns whose
  /// right-hand sides become nonzero in about the same rows, and returns the pivots.
  constexpr sequence<pivot> solve_together(const matrix& right, const sequence<int>& columns,
                                           matrix& x) const {
    sequence<pivot> pivots = pivots_;
    const int factors = list_of_factors(pivots);
    for (const column_group& group : column_groups(n_, order_, factors_).of(right, columns))
      solve_group(right, group.columns, factors, x);
    return pivots;
  }

private:
  static constexpr int none = -1;

  /// The factors in their numeric layout, a row for each pivot.
  constexpr int list_of_factors(sequence<pivot>& pivots) const {
    sequence<int> rows;
    for (int step = 0; step < n_; ++step) {
      const int p = order_[step];
      int inverse = inverses_[p];
      if (inverse == graph::zero) { // not coupled to any remaining unknown
        inverse = divide(g_, graph::one, left_.entry[p * n_ + p]);
        note(p, inverse, pivots);
      }
      sequence<int> row{inverse};
      for (int later = step + 1; later < n_; ++later) row.push(factors_[p * n_ + order_[later]]);
      rows.push(list_of(g_, row));
    }
    return list_of(g_, rows);
  }

  constexpr void solve_group(const matrix& right, const sequence<int>& group, int factors, matrix& x) const {
    sequence<int> rows;
    for (int p : order_) {
      sequence<int> row;
      for (int j : group) row.push(right(p, j).node());
      rows.push(list_of(g_, row));
    }
    const int node = g_.find_or_append({operation::symmetric_solve, factors, list_of(g_, rows)});
    const sequence<char> filled = symmetric_columns(g_, g_[node]).steps().filled;
    for (int step = 0, index = 0; step < n_; ++step)
      for (int j : group) {
        const int place = index++;
        if (filled[step] != 0) x(order_[step], j) = {g_, component(g_, node, place)};
      }
  }

  constexpr void eliminate(int p) {
    int* const entry = left_.entry;
    positions_[p] = order_.push(p);
    if (left_.degree[p] == 0) return;
    const int inverse = inverses_[p] = divide(g_, graph::one, entry[p * n_ + p]);
    note(p, inverse, pivots_);
    for (int i = n_ - 1; i >= 0; --i) {
      if (positions_[i] != none || entry[p * n_ + i] == graph::zero) continue;
      --left_.degree[i];
      const int by = factors_[p * n_ + i] = multiply(g_, entry[p * n_ + i], inverse);
      for (int j = i; j >= 0; --j)
        if (positions_[j] == none && entry[p * n_ + j] != graph::zero)
          left_.set(i, j, subtract(g_, entry[i * n_ + j], multiply(g_, by, entry[p * n_ + j])));
    }
  }

  /// Forms the dependency of one unknown on those outside of its branch.
  constexpr void respond(int p, const sequence<char>& filled, const sequence<int>& weights) {
    const int row = p * n_;
    const int* const own = factors_.begin() + row;
    int direct = 0, formed = 0, remaining = 0, uses = 0, of_all = 0;
    sequence<int> both_zero(n_, 0); // the number of columns in which both right-hand sides are zero
    sequence<char> is_within(n_, 0), is_outside(n_, 0);
    int* const zeros = both_zero.begin(); // pointers, because compilers interpret every call
    char *const within = is_within.begin(), *const outside = is_outside.begin();
    const int* const responses = responses_.begin();
    const char* const replaced = is_within_.begin();
    for (int j = 0; j < weights.size(); ++j) {
      const int column = j * n_;
      const char* const of = filled.begin() + column;
      if (of[p] != 0 || weights[j] == 0) continue;
      ++of_all;
      for (int k = 0; k < n_; ++k)
        if (of[k] == 0) ++zeros[k];
    }
    for (int k = 0; k < n_; ++k) {
      if (own[k] == graph::zero) continue;
      ++direct;
      within[k] = 2 * zeros[k] > of_all ? 1 : 0;
    }
    for (int k : order_) // an unknown on which another one of these depends is not replaced
      for (int i = 0; i < n_ && within[k] != 0; ++i)
        if (responses[k * n_ + i] != graph::zero) within[i] = 0;
    sequence<char> in_branch = is_within; // with the unknowns that these replace themselves
    char* const branch = in_branch.begin();
    for (int k = 0; k < n_; ++k)
      for (int i = 0; i < n_ && within[k] != 0; ++i)
        if (replaced[k * n_ + i] != 0) branch[i] = 1;
    for (int j = 0; j < weights.size(); ++j) {
      const int column = j * n_;
      const char* const of = filled.begin() + column;
      bool is_zero = of[p] == 0;
      for (int k = 0; k < n_; ++k) is_zero = is_zero && (branch[k] == 0 || of[k] == 0);
      if (is_zero) uses += weights[j];
    }
    for (int k = 0; k < n_; ++k) {
      if (own[k] != graph::zero && within[k] == 0) outside[k] = 1;
      for (int i = 0; i < n_ && within[k] != 0; ++i)
        if (responses[k * n_ + i] != graph::zero) outside[i] = 1, ++formed;
    }
    for (int i = 0; i < n_; ++i) remaining += outside[i];
    if (uses * (direct - remaining) <= 2 * formed) return;
    for (int i = 0; i < n_; ++i) {
      is_within_[p * n_ + i] = branch[i];
      int sum = outside[i] != 0 ? own[i] : graph::zero;
      for (int k = 0; k < n_ && outside[i] != 0; ++k)
        if (within[k] != 0) sum = subtract(g_, sum, multiply(g_, own[k], responses_[k * n_ + i]));
      responses_[p * n_ + i] = sum;
    }
  }

  /// Whether an unknown follows from those outside of its branch.
  constexpr bool is_response(int p, const sequence<int>& right) const {
    if (is_within_.empty() || right[p] != graph::zero) return false;
    const int row = p * n_;
    const char* const within = is_within_.begin() + row;
    const int* const f = right.begin();
    for (int k = 0, end = n_; k < end; ++k)
      if (within[k] != 0 && f[k] != graph::zero) return false;
    return true;
  }

  constexpr void note(int p, int quotient, sequence<pivot>& all) const {
    record_pivot(all, p, {g_, quotient}, {g_, left_.entry[p * n_ + p]}, diagonal_[p]);
  }

  constexpr void reduce(sequence<int>& right) const {
    int* const f = right.begin();
    for (int p : order_) {
      const int row = p * n_;
      const int* const by = factors_.begin() + row;
      for (int i = n_ - 1; i >= 0 && f[p] != graph::zero; --i)
        if (by[i] != graph::zero) f[i] = subtract(g_, f[i], multiply(g_, by[i], f[p]));
    }
  }

  /// Computes an unknown from those eliminated later.
  constexpr int unknown(int step, const sequence<int>& right, const sequence<int>& x,
                        sequence<pivot>& pivots) const {
    const int p = order_[step];
    int sum = graph::zero;
    if (inverses_[p] == graph::zero) { // not coupled to any remaining unknown: one division suffices
      sum = divide_in_lowest_terms(g_, right[p], left_.entry[p * n_ + p]);
      note(p, sum, pivots);
    } else {
      sum = multiply(g_, right[p], inverses_[p]);
    }
    const int row = p * n_;
    const int* const by = (is_response(p, right) ? responses_ : factors_).begin() + row;
    const int* const known = x.begin();
    for (int i = 0, end = n_; i < end; ++i)
      if (by[i] != graph::zero && known[i] != graph::zero)
        sum = subtract(g_, sum, multiply(g_, by[i], known[i]));
    return sum;
  }

  graph& g_;
  int n_;
  detail::symmetric_elimination left_;
  sequence<expression> diagonal_{};
  sequence<int> order_{};
  sequence<int> inverses_, factors_; ///< row p: the multipliers of pivot p
  sequence<int> positions_;          ///< in the elimination order, by row
  sequence<pivot> pivots_{};
  sequence<int>
      responses_{}; ///< row p: the multipliers of unknown p if the right-hand sides of its branch are zero
  sequence<char> is_within_{}; ///< row p: the unknowns of its branch that these multipliers replace
};

/// Solves one system M x = f.
constexpr symmetric_solution solve_symmetric(graph& g, const matrix& m, const sequence<expression>& f) {
  return symmetric_factorization(g, m).solve(f);
}

} // namespace kanexpr::symbolic
