#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/check_contents.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/mechanics/skeleton/kinematic_equations.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

namespace detail {

/// Checks the kinematic differential equations. The coordinate rates in each equation are collected once;
/// coefficients are formed only for equations that are coupled or that do not look linear.
class kinematics_checker {
public:
  constexpr kinematics_checker(const mechanism& m, const contents& held) : m_(m), held_(held) {
    for (const expression& e : m.kinematics) {
      rates_.push({});
      held.collect(e, kind::coordinate_rate, rates_.back());
    }
  }

  constexpr sentence run() {
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

  /// Collects the speeds in a declared velocity. A speed need not be a combination of coordinate rates: the
  /// spin of a wheel whose angle does not matter appears only in an angular velocity.
  constexpr void collect_speeds(const vector& declared, sequence<int>& speeds) const {
    declared.each_entry([&](expression e) { held_.collect(e, kind::speed, speeds); });
  }

  constexpr void each_symbol_appears() {
    sequence<int> seen;
    for (const expression& e : m_.kinematics) {
      held_.collect(e, kind::coordinate_rate, seen);
      held_.collect(e, kind::speed, seen);
    }
    for (const frame& f : m_.frames) collect_speeds(f.angular_velocity, seen);
    for (const point& p : m_.points) collect_speeds(p.velocity, seen);
    for (const expression& rate : m_.coordinate_rates)
      if (!seen.contains(rate.node()))
        return fail(
            {"the rate of coordinate ", called(m_, rate), " appears in no kinematic differential equation"});
    for (int i = 0; i < m_.speeds_of_motion(); ++i)
      if (const expression& u = m_.speeds[i]; !seen.contains(u.node()))
        return fail({"speed ", called(m_, u), " appears in no kinematic differential equation"});
  }

  constexpr void counts() {
    const int equations = m_.kinematics.size(), coordinates = m_.coordinates.size();
    if (equations == coordinates) return;
    fail({"expected as many kinematic differential equations as coordinates, got ",
          base::counted(equations).view(), " for ", base::counted(coordinates).view()});
  }

  constexpr void form(expression e) {
    constexpr const char* of = "a kinematic differential equation";
    if (const sentence symbol = symbol_in(m_, held_, e, {kind::speed_rate, kind::auxiliary_speed}))
      fail({of, " contains the ", symbol.view()});
    if (!found_) found_ = check_no_state_variable(m_, held_, e, of);
    if (!found_) found_ = check_prescribed(m_, held_, e, 1, of);
    if (!found_) found_ = check_linear(m_, held_, e, of);
  }

  /// Checks that the equations can be solved: those with one unknown rate one after another, the remaining
  /// ones as coupled systems.
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
    sequence<sequence<int>> rates_of_equation(n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (!k.k_rates(i, j).is_zero()) rates_of_equation[i].push(j);
    const symbolic::block_triangular_form form(rates_of_equation);
    sequence<char> has_equation(n, 0);
    for (const symbolic::diagonal_block& part : form.parts()) {
      if (!is_regular(k, part)) return cannot_solve(part.columns[0]);
      for (int j : part.columns) has_equation[j] = 1;
    }
    if (!form.is_regular()) cannot_solve(has_equation.find(0));
  }

  /// Whether the coupled equations are regular in at least one configuration.
  constexpr bool is_regular(const linear_kinematics& k, const symbolic::diagonal_block& part) const {
    const int size = part.rows.size();
    if (size == 1) return true;
    symbolic::matrix a(*m_.g, size, size);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) a(i, j) = k.k_rates(part.rows[i], part.columns[j]);
    return has_independent_rows(a, m_);
  }

  constexpr void cannot_solve(int rate) {
    fail({"the kinematic differential equations cannot be solved for the rate of coordinate ",
          called(m_, m_.coordinates[rate])});
  }

  const mechanism& m_;
  const contents& held_;
  sequence<sequence<int>> rates_{}; ///< nodes of the coordinate rates in each equation
  sentence found_{};
};

} // namespace detail

} // namespace kanexpr::mechanics
