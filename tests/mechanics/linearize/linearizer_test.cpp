// builds: clang++
// The linearization in the states only, compared with that of all equations, solved numerically; and general
// forms written by hand.
#include "mechanics/random/bound_mechanism.hpp"
#include "mechanics/random/elimination.hpp"
#include "mechanics/random/random_mechanism.hpp"
#include "mechanics/random/random_springs.hpp"

#include <gtest/gtest.h>

namespace {

namespace mechanics = kanexpr::mechanics;
using Eigen::Index;
using Eigen::MatrixXd;
using kanexpr::base::name;
using kanexpr::symbolic::constant;
using kanexpr::symbolic::exactly;
using kanexpr::symbolic::expression;
using kanexpr::symbolic::graph;
using kanexpr::symbolic::symbol_kind;
using kanexpr::symbolic::variable;
using mechanics::quantity;

MatrixXd beside(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd both(a.rows(), a.cols() + b.cols());
  both.leftCols(a.cols()) = a;
  both.rightCols(b.cols()) = b;
  return both;
}

// The difference between the two at the mechanism's state; zero if that is nearly singular.
std::optional<double> disagreement(recipe::bound_mechanism& one) {
  one.derived.constrain();
  if (one.derived.mistake()) return std::nullopt;
  const elimination::solved rates = elimination::solve(
      one.found(quantity::implicit_mass_matrix),
      beside(one.found(quantity::implicit_state_matrix), one.found(quantity::implicit_input_matrix)));
  const MatrixXd states = beside(one.found(quantity::state_matrix), one.found(quantity::input_matrix));
  if (!(rates.least_pivot > 1e-3) || !(elimination::largest(states) < 1e3)) return std::nullopt;
  std::vector<int> rows;
  for (int i : one.derived.coordinates().independent) rows.push_back(i);
  for (int i : one.derived.speeds().independent) rows.push_back(static_cast<int>(one.m.q.size()) + i);
  double apart = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (Index j = 0; j < states.cols(); ++j)
      apart = std::max(apart, std::abs(states(static_cast<Index>(i), j) - rates.x(rows[i], j)));
  return apart / (1 + elimination::largest(rates.x));
}

TEST(linearizer, gives_the_same_in_states_and_in_full) {
  int compared = 0, constrained = 0;
  for (unsigned seed = 0; compared < 100 && seed < 2000 && !HasFailure(); ++seed) {
    SCOPED_TRACE("mechanism " + std::to_string(seed));
    recipe::mechanism m = recipe::generator(seed, false).run();
    recipe::random_springs(m, seed).hang();
    std::vector<recipe::constraint> bounds;
    if (seed % 3 != 0 && m.u.size() > 1) bounds = recipe::random_constraints(m, seed).run();
    recipe::bound_mechanism one(m, bounds);
    const std::optional<double> apart = disagreement(one);
    if (!apart) continue;
    ++compared;
    if (!bounds.empty()) ++constrained;
    EXPECT_LE(*apart, 1e-9);
  }
  EXPECT_EQ(compared, 100);
  EXPECT_GT(constrained, 40);
}

// A pendulum of length L on a string: x and y with x² + y² = L², m ẍ = m g + 2 x λ, m ÿ = 2 y λ + F.
struct pendulum_by_hand {
  graph g;
  expression x = symbol(symbol_kind::coordinate, "x", 0), y = symbol(symbol_kind::coordinate, "y", 1),
             u = symbol(symbol_kind::speed, "u", 0), v = symbol(symbol_kind::speed, "v", 1),
             xdot = symbol(symbol_kind::coordinate_rate, "x", 0),
             ydot = symbol(symbol_kind::coordinate_rate, "y", 1),
             udot = symbol(symbol_kind::speed_rate, "u", 0), vdot = symbol(symbol_kind::speed_rate, "v", 1),
             lambda = symbol(symbol_kind::multiplier, "lambda", 0),
             force = symbol(symbol_kind::input, "F", 0), m = symbol(symbol_kind::parameter, "m", 0),
             L = symbol(symbol_kind::parameter, "L", 1), gravity = symbol(symbol_kind::parameter, "g", 2);

  mechanics::general_form form() {
    mechanics::general_form f;
    f.q = {x, y}, f.u = {u, v}, f.qdot = {xdot, ydot}, f.udot = {udot, vdot}, f.lambda = {lambda},
    f.r = {force};
    f.coordinates = {{0}, {1}}, f.speeds = {{0}, {1}};
    f.f_c = {x * x + y * y - L * L};
    f.f_v = {2 * x * u + 2 * y * v};
    f.f_a = {2 * (xdot * u + x * udot + ydot * v + y * vdot)};
    f.f_0 = {xdot, ydot}, f.f_1 = {-u, -v};
    f.f_2 = {m * udot, m * vdot};
    f.f_3 = {-(m * gravity), -force};
    f.f_4 = {-(2 * x * lambda), -(2 * y * lambda)};
    return f;
  }
  // Hanging with L = 2, m = 3, g = 5: at rest, or off the circle and falling.
  MatrixXd numbers(const kanexpr::symbolic::matrix& a, double falling = 0) {
    const double square = falling * falling;
    const auto value_of = [&](int id) -> double {
      if (id == x.node() || id == L.node()) return 2;
      if (id == u.node() || id == xdot.node()) return falling;
      if (id == udot.node()) return -square / 2;
      if (id == m.node()) return 3;
      if (id == gravity.node()) return 5;
      return id == lambda.node() ? -3 * (10 + square) / 8 : 0;
    };
    const auto values = kanexpr::symbolic::values_at(g, kanexpr::symbolic::nodes_of(a.entries), value_of);
    MatrixXd out(a.rows, a.columns);
    for (int i = 0; i < a.rows; ++i)
      for (int j = 0; j < a.columns; ++j) out(i, j) = values[i * a.columns + j];
    return out;
  }

private:
  expression symbol(symbol_kind kind, const char* called, int place) {
    return variable(g, {kind, name(called), place});
  }
};

TEST(linearizer, takes_a_general_form_that_is_written_by_hand) {
  pendulum_by_hand p;
  mechanics::linearizer l(p.g, p.form());
  const auto& full = l.implicit_form();
  EXPECT_EQ(full.mass.rows, 5);
  EXPECT_EQ(full.state.columns, 2);
  EXPECT_EQ(full.input.columns, 1);
  MatrixXd A(2, 2), B(2, 1);
  A << 0, 1, -5.0 / 2, 0;
  B << 0, 1.0 / 3;
  EXPECT_LE((p.numbers(l.explicit_form().state) - A).norm(), 1e-15);
  EXPECT_LE((p.numbers(l.explicit_form().input) - B).norm(), 1e-15);
  // the tension of the string does not change to first order, and a sensor of ẍ detects no change
  const mechanics::explicit_linearization seen = l.outputs({p.udot, p.vdot, p.y + p.xdot});
  MatrixXd C(3, 2);
  C << 0, 0, -5.0 / 2, 0, 1, 0;
  EXPECT_LE((p.numbers(seen.state) - C).norm(), 1e-15);
}

// u̇ = g − x s, v̇ = F/m − y s with s = (x g + y F/m + u² + v²)/(x² + y²), for any position of the bob.
TEST(linearizer, takes_a_general_form_off_its_constraints) {
  pendulum_by_hand p;
  mechanics::linearizer l(p.g, p.form(), mechanics::directions::free);
  EXPECT_EQ(l.variations().size(), 5);
  const mechanics::explicit_linearization all = l.of_all_rates();
  MatrixXd A(4, 4), B(4, 1);
  A << 0, 0, 1, 0,       //
      0, 0, 0, 1,        //
      1.0 / 4, 0, -1, 0, //
      0, -11.0 / 4, 0, 0;
  B << 0, 0, 0, 1.0 / 3;
  EXPECT_LE((p.numbers(all.state, 1) - A).norm(), 1e-15);
  EXPECT_LE((p.numbers(all.input, 1) - B).norm(), 1e-15);
}

} // namespace
