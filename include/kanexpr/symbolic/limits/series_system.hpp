#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/limits/operation_series.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

#include <optional>
#include <utility>
#include <vector>

/// Linear systems of series.
namespace kanexpr::symbolic::limits {

/// A linear system A x = b with A stored by rows, or Aᵀ x = b.
class series_system {
public:
  series_system(graph& g, operation op, std::vector<series> a, std::vector<series> b)
      : g_(g), op_(op), n_(static_cast<int>(b.size())), a_(std::move(a)), b_(std::move(b)) {}

  /// Computes all of x; returns the obstacle if there is no solution.
  obstacle solve(std::vector<series>& x) const {
    if (is_regular_and_symbolic()) return by_first_terms(x);
    return n_ <= 3 ? by_cofactors(x) : by_elimination(x);
  }

private:
  const series& at(int i, int j) const {
    const bool is_plain = op_ == operation::solve;
    return a_[static_cast<std::size_t>(is_plain ? i % n_ * n_ + j % n_ : j % n_ * n_ + i % n_)];
  }
  const series& right(int i) const { return b_[static_cast<std::size_t>(i)]; }
  std::vector<generic_values> values_of_first() const {
    std::vector<generic_values> values;
    for (int i = 0; i < n_; ++i)
      for (int j = 0; j < n_; ++j) values.push_back(at(i, j)[0].at());
    return values;
  }

  bool is_regular_and_symbolic() const {
    bool is_symbolic = false;
    for (const series& s : a_) {
      if (s.order() < 0 || s.end() <= 0) return false;
      is_symbolic = is_symbolic || !s[0].is_number();
    }
    return is_symbolic && solved(values_of_first(), std::vector<generic_values>(b_.size())).has_value();
  }

  /// Solves A_0 x_k = b_k - Σ A_j x_{k-j} with one factorization of A_0.
  obstacle by_first_terms(std::vector<series>& x) const {
    int first = series::all_orders, end = series::all_orders, most = series::all_orders;
    bool is_constant = true;
    for (const auto* all : {&a_, &b_})
      for (const series& s : *all) {
        most = (std::min)(most, s.max_order()), is_constant = is_constant && s.is_constant();
        if (all == &b_) first = (std::min)(first, s.order()), end = (std::min)(end, s.end());
      }
    for (const series& s : a_)
      if (s.end() != series::all_orders) end = (std::min)(end, s.end() + first);
    end = (std::min)({end, most + 1, is_constant ? 1 : end});
    std::vector<std::vector<coefficient>> terms; // by order
    for (int k = first; k < end; ++k) {
      std::vector<coefficient> rest;
      for (int i = 0; i < n_; ++i) {
        rest.push_back(right(i)[k]);
        for (int j = 0; j < n_; ++j)
          for (int l = first; l < k; ++l)
            rest.back() =
                rest.back() -
                at(i, j)[k - l] * terms[static_cast<std::size_t>(l - first)][static_cast<std::size_t>(j)];
      }
      terms.push_back(solved_by_first(rest));
    }
    x.clear();
    for (std::size_t i = 0; i < b_.size(); ++i) {
      std::vector<coefficient> component;
      component.reserve(terms.size());
      for (const std::vector<coefficient>& all : terms) component.push_back(all[i]);
      x.emplace_back(first, std::move(component), is_constant ? series::all_orders : end, most);
    }
    return obstacle::none;
  }

  std::vector<coefficient> solved_by_first(const std::vector<coefficient>& b) const {
    sequence<int> entries, rights;
    std::vector<generic_values> values;
    for (const series& s : a_) entries.push(s[0].in(g_).node());
    for (const coefficient& c : b) rights.push(c.in(g_).node()), values.push_back(c.at());
    const int factors = factorization(g_, entries, n_), all = solution(g_, op_, factors, list_of(g_, rights));
    const std::vector<generic_values> x = *solved(values_of_first(), values);
    std::vector<coefficient> found;
    found.reserve(x.size());
    for (int i = 0; i < n_; ++i)
      found.emplace_back(expression{g_, component(g_, all, i)}, x[static_cast<std::size_t>(i)]);
    return found;
  }

  series cofactor(int i, int j) const {
    if (n_ == 2) return i == j ? at(i + 1, j + 1) : -at(i + 1, j + 1);
    const series product = at(i + 1, j + 1) * at(i + 2, j + 2);
    return product - at(i + 1, j + 2) * at(i + 2, j + 1);
  }

  obstacle by_cofactors(std::vector<series>& x) const {
    series determinant;
    for (int i = 0; i < n_; ++i) determinant = determinant + at(i, 0) * cofactor(i, 0);
    if (determinant.is_zero()) return obstacle::singular_system;
    if (!determinant.has_terms()) return obstacle::truncated;
    for (int j = 0; j < n_; ++j) {
      series sum;
      for (int i = 0; i < n_; ++i) sum = sum + right(i) * cofactor(i, j);
      x.push_back(sum / determinant);
    }
    return obstacle::none;
  }

  /// Eliminates with pivots of the lowest order.
  obstacle by_elimination(std::vector<series>& x) const {
    std::vector<series> entries;
    bool is_known = true;
    for (int i = 0; i < n_; ++i)
      for (int j = 0; j < n_; ++j) entries.push_back(at(i, j));
    x = b_;
    const auto rank_pivot = [&is_known](const series& s) -> std::optional<std::pair<int, double>> {
      is_known = is_known && (s.has_terms() || s.is_zero());
      if (!s.has_terms()) return std::nullopt;
      const double size = std::abs(s.lead().at()[0].value);
      return std::pair(-s.order(), base::is_number(size) ? size : 0);
    };
    if (eliminate(entries, x, rank_pivot)) return obstacle::none;
    return is_known ? obstacle::singular_system : obstacle::truncated;
  }

  graph& g_;
  operation op_;
  int n_;
  std::vector<series> a_, b_;
};

} // namespace kanexpr::symbolic::limits
