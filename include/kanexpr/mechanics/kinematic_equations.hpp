#pragma once

#include <kanexpr/mechanics/mechanism.hpp>
#include <kanexpr/symbolic/differentiate.hpp>
#include <kanexpr/symbolic/solve.hpp>
#include <kanexpr/symbolic/substitute.hpp>

namespace kanexpr::mechanics {

/// The kinematic differential equations K(q,t) q̇ + k(q,u,t) = 0.
struct linear_kinematics {
  symbolic::matrix k_rates;       ///< K
  sequence<expression> remainder; ///< k
};

constexpr linear_kinematics linear_in_rates(const mechanism& m) {
  const int n = m.kinematics.size();
  linear_kinematics out{symbolic::matrix(*m.g, n, m.coordinate_rates.size()), {}};
  for (int j = 0; j < m.coordinate_rates.size(); ++j) {
    symbolic::derivation by_rate(*m.g);
    by_rate.set_rate(m.coordinate_rates[j], m.one());
    for (int i = 0; i < n; ++i) out.k_rates(i, j) = by_rate.of(m.kinematics[i]);
  }
  symbolic::substitution at_rest(*m.g);
  for (const expression& rate : m.coordinate_rates) at_rest.replace(rate, m.zero());
  for (const expression& e : m.kinematics) out.remainder.push(at_rest.in(e));
  return out;
}

namespace detail {

/// The unsolved equations and rates that hang together with equation `first`.
struct coupled_block {
  sequence<int> equations, rates;
};

constexpr coupled_block block_of(const linear_kinematics& k, int first, const sequence<int>& equation_done,
                                 const sequence<int>& rate_done) {
  coupled_block block;
  block.equations.push(first);
  for (int e = 0; e < block.equations.size(); ++e)
    for (int j = 0; j < k.k_rates.columns; ++j) {
      if (rate_done[j] != 0 || k.k_rates(block.equations[e], j).is_zero() || block.rates.contains(j))
        continue;
      block.rates.push(j);
      for (int i = 0; i < k.k_rates.rows; ++i)
        if (equation_done[i] == 0 && !k.k_rates(i, j).is_zero() && !block.equations.contains(i))
          block.equations.push(i);
    }
  return block;
}

} // namespace detail

/// q̇ as expressions of q, u and t. Equations with a single unknown rate are solved first, one after another;
/// what is truly coupled is solved block by block with cofactors. An unsolvable block leaves its rates zero
/// (`check` has named the mistake before).
constexpr sequence<expression> solve_for_rates(const mechanism& m) {
  const linear_kinematics k = linear_in_rates(m);
  const int equations = k.k_rates.rows, n = k.k_rates.columns;
  sequence<expression> rates(n, m.zero());
  sequence<int> equation_done(equations, 0), rate_done(n, 0);

  const auto right_side = [&](int i) {
    expression b = -k.remainder[i];
    for (int j = 0; j < n; ++j)
      if (rate_done[j] != 0) b -= k.k_rates(i, j) * rates[j];
    return b;
  };

  for (bool progress = true; progress;) {
    progress = false;
    for (int i = 0; i < equations; ++i) {
      if (equation_done[i] != 0) continue;
      int unknowns = 0, only = none;
      for (int j = 0; j < n; ++j)
        if (rate_done[j] == 0 && !k.k_rates(i, j).is_zero()) ++unknowns, only = j;
      if (unknowns != 1) continue;
      rates[only] = right_side(i) / k.k_rates(i, only);
      equation_done[i] = rate_done[only] = 1;
      progress = true;
    }
  }
  for (int first = 0; first < equations; ++first) {
    if (equation_done[first] != 0) continue;
    const detail::coupled_block block = detail::block_of(k, first, equation_done, rate_done);
    if (block.equations.size() != block.rates.size()) continue;
    const int size = block.rates.size();
    symbolic::matrix a(*m.g, size, size);
    sequence<expression> b;
    for (int i = 0; i < size; ++i) {
      b.push(right_side(block.equations[i]));
      for (int j = 0; j < size; ++j) a(i, j) = k.k_rates(block.equations[i], block.rates[j]);
    }
    const sequence<expression> solved = symbolic::solve_by_cofactors(*m.g, a, b);
    for (int j = 0; j < size; ++j) rates[block.rates[j]] = solved[j];
    for (int i : block.equations) equation_done[i] = 1;
    for (int j : block.rates) rate_done[j] = 1;
  }
  return rates;
}

} // namespace kanexpr::mechanics
