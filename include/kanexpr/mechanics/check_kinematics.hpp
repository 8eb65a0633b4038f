#pragma once

#include <kanexpr/mechanics/contents.hpp>
#include <kanexpr/mechanics/kinematic_equations.hpp>
#include <kanexpr/mechanics/problem.hpp>

namespace kanexpr::mechanics {

namespace detail {

/// Whether the coefficient of a speed or rate holds no other: exact where `contents` only looks.
constexpr bool is_linear(expression e, expression symbol) {
  const expression slope = symbolic::differentiate(e, symbol);
  return !contents(e.owner()).holds_any(slope, {contents::kind::speed, contents::kind::coordinate_rate});
}

/// The checks of the kinematic differential equations. The coordinate rates that an equation holds are
/// collected once; coefficients are formed only for equations that are truly coupled, or that do not look
/// linear.
class checking_kinematics {
public:
  constexpr checking_kinematics(const mechanism& m, const contents& c) : m_(m), c_(c) {
    for (const expression& e : m.kinematics) {
      sequence<int> held;
      c.collect(e, kind::coordinate_rate, held);
      rates_.push(held);
    }
  }

  constexpr problem run() {
    each_symbol_appears();
    if (!found_) counts();
    for (const expression& e : m_.kinematics)
      if (!found_) form(e);
    if (!found_) solvable();
    return found_;
  }

private:
  using kind = symbolic::symbol_kind;

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!found_) found_ = sentence(pieces);
  }
  constexpr std::string_view called(expression symbol) const {
    return m_.g->symbol_at(symbol.node()).called.view();
  }

  constexpr void each_symbol_appears() {
    sequence<char> seen(m_.g->size(), 0);
    sequence<int> speeds;
    for (const expression& e : m_.kinematics) c_.collect(e, kind::speed, speeds);
    for (int id : speeds) seen[id] = 1;
    for (const sequence<int>& held : rates_)
      for (int id : held) seen[id] = 1;
    for (const expression& q : m_.coordinate_rates)
      if (seen[q.node()] == 0)
        return fail({"coordinate ", called(q), " has its rate in no kinematic differential equation"});
    for (const expression& u : m_.speeds)
      if (seen[u.node()] == 0)
        return fail({"speed ", called(u), " appears in no kinematic differential equation"});
  }

  constexpr void counts() {
    const int equations = m_.kinematics.size(), coordinates = m_.coordinates.size();
    if (equations == coordinates) return;
    name e, q;
    e.append(equations), q.append(coordinates);
    fail({"there must be as many kinematic differential equations as coordinates, and there are ", e.view(),
          " for ", q.view()});
  }

  constexpr void form(expression e) {
    if (c_.holds(e, kind::speed_rate))
      return fail(
          {"a kinematic differential equation holds the rate of speed ", c_.name_of(e, kind::speed_rate)});
    if (c_.holds(e, kind::input))
      return fail({"a kinematic differential equation holds the input ", c_.name_of(e, kind::input),
                   ", whose rate is not known"});
    if (c_.looks_linear(e)) return;
    for (const expression& q : m_.coordinate_rates)
      if (!is_linear(e, q))
        return fail(
            {"a kinematic differential equation is not linear in the rate of coordinate ", called(q)});
    for (const expression& u : m_.speeds)
      if (!is_linear(e, u))
        return fail({"a kinematic differential equation is not linear in speed ", called(u)});
  }

  /// Equations with one unknown rate are solved one after another; what is left hangs together and needs a
  /// determinant.
  constexpr void solvable() {
    const int n = m_.coordinates.size();
    sequence<int> solved;
    sequence<char> done(n, 0);
    for (bool progress = true; progress;) {
      progress = false;
      for (int i = 0; i < n; ++i) {
        int unknowns = 0, only = none;
        for (int id : rates_[i])
          if (!solved.contains(id)) ++unknowns, only = id;
        if (done[i] != 0 || unknowns != 1) continue;
        solved.push(only);
        done[i] = 1;
        progress = true;
      }
    }
    if (solved.size() == n) return;
    const linear_kinematics k = linear_in_rates(m_);
    sequence<int> equation_done, rate_done;
    for (int i = 0; i < n; ++i) {
      equation_done.push(done[i]);
      rate_done.push(solved.contains(m_.coordinate_rates[i].node()) ? 1 : 0);
    }
    for (int first = 0; first < n; ++first) {
      if (equation_done[first] != 0) continue;
      const coupled_block block = block_of(k, first, equation_done, rate_done);
      if (!regular(k, block)) return cannot_solve(block, rate_done);
      for (int i : block.equations) equation_done[i] = 1;
      for (int j : block.rates) rate_done[j] = 1;
    }
  }

  constexpr bool regular(const linear_kinematics& k, const coupled_block& block) const {
    const int size = block.rates.size();
    if (block.equations.size() != size) return false;
    if (size > 8) return true; // too many minors to form
    symbolic::matrix a(*m_.g, size, size);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) a(i, j) = k.k_rates(block.equations[i], block.rates[j]);
    return !symbolic::determinant(*m_.g, a).is_zero();
  }

  constexpr void cannot_solve(const coupled_block& block, const sequence<int>& rate_done) {
    int rate = block.rates.empty() ? rate_done.find(0) : block.rates[0];
    fail({"the kinematic differential equations cannot be solved for the rate of coordinate ",
          called(m_.coordinates[rate])});
  }

  const mechanism& m_;
  const contents& c_;
  sequence<sequence<int>> rates_; ///< nodes of the coordinate rates that each equation holds
  problem found_;
};

} // namespace detail

} // namespace kanexpr::mechanics
