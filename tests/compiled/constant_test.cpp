// Results and linearizations in constant expressions: most of the test takes place during compilation.
#include <kanexpr/compiled/constant_values.hpp>
#include <kanexpr/numeric/as_eigen.hpp>

#include <models/bicycle.hpp>
#include <models/four_bar.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr;
using numeric::as_eigen;

namespace pendulum {

using namespace simple_pendulum;
using eom = equations_of_motion<System>;
using lin = linearization<System>;

constexpr auto x = constant_state<System>({{q, 0.5}, {"u", 4}});
constexpr auto p = constant_parameters<System>({{m, 2}, {l, 3}, {g, 10}, {c, 0}});
constexpr auto r = constant_inputs<System>({{T, 0}});
static_assert(x == std::array{0.5, 4.0} && p == std::array{2.0, 3.0, 10.0, 0.0} && r == std::array{0.0});

constexpr auto both = eom::together(eom::mass_matrix, eom::kinetic_energy, eom::rhs).constant(x, p, r);
static_assert(std::get<0>(both) == 18 && std::get<1>(both) == 144 && std::get<2>(both)(0) == 4);
static_assert(eom::inertia_forces.constant_at(x, p, r, {2})(0) == -36);

// About the lowest position, the torque of gravity is −m g l q.
constexpr auto hanging = lin::explicit_form.constant({0, 0}, p, r);
static_assert(std::get<0>(hanging)(0, 0) == 0 && std::get<0>(hanging)(0, 1) == 1);
static_assert(std::get<0>(hanging)(1, 1) == 0 && std::get<1>(hanging)(0, 0) == 0);

TEST(constant, is_that_of_a_call) {
  const lin::state state(0.5, 4);
  const lin::parameters parameters(2, 3, 10, 0);
  const lin::inputs inputs(0.0);
  constexpr auto found = lin::explicit_form.constant(x, p, r);
  const auto [a, b] = lin::explicit_form(state, parameters, inputs);
  EXPECT_LE((as_eigen(std::get<0>(found)) - a).norm(), 1e-15 * a.norm());
  EXPECT_LE((as_eigen(std::get<1>(found)) - b).norm(), 1e-15 * b.norm());
  constexpr auto outputs = lin::outputs<q, acceleration_of<P>>.constant(x, p, r);
  const auto [c, d] = lin::outputs<q, acceleration_of<P>>(state, parameters, inputs);
  EXPECT_LE((as_eigen(std::get<0>(outputs)) - c).norm(), 1e-15 * c.norm());
  EXPECT_LE((as_eigen(std::get<1>(outputs)) - d).norm(), 1e-15 * d.norm());
  constexpr auto at = lin::explicit_form_at.constant_at(x, p, r, {0.7});
  const auto [a_at, b_at] =
      lin::explicit_form_at(state, parameters, inputs, Eigen::Matrix<double, 1, 1>(0.7));
  EXPECT_LE((as_eigen(std::get<0>(at)) - a_at).norm(), 1e-15 * a_at.norm());
  EXPECT_LE((as_eigen(std::get<1>(at)) - b_at).norm(), 1e-15 * b_at.norm());
}

TEST(constant, values_by_name_leave_no_gap) {
  const auto lacking = constant_parameters<System>({{m, 2}, {l, 3}, {g, 10}});
  EXPECT_EQ(lacking[0], 2);
  EXPECT_TRUE(std::isnan(lacking[3]));
  const auto doubled = constant_parameters<System>({{m, 2}, {l, 3}, {g, 10}, {c, 0}, {m, 2}});
  EXPECT_TRUE(std::isnan(doubled[0]));
  EXPECT_EQ(doubled[1], 3);
  const auto unknown = constant_parameters<System>({{m, 2}, {l, 3}, {g, 10}, {"cc", 0}, {c, 0}});
  for (const double value : unknown) EXPECT_TRUE(std::isnan(value));
  const auto dependent = constant_state<four_bar::System>({{four_bar::q1, 1}, {four_bar::u1, 2}});
  EXPECT_EQ(dependent, (std::array<double, 6>{1, 0, 0, 2, 0, 0}));
}

} // namespace pendulum

// The benchmark of Meijaard, Papadopoulos, Ruina & Schwab (2007), M q̈ + v C1 q̇ + (g K0 + v² K2) q = f with
// q = (lean, steer), computed by the compiler from the nonlinear equations.
namespace benchmark {

using namespace bicycle;
using eom = equations_of_motion<System>;
using lin = linearization<System>;
using matrix = numeric::fixed_matrix<double, 2, 2>;

constexpr auto straight_ahead(double v) {
  return constant_state<System>({{q1, 0}, {q2, 0}, {q5, 0}, {u2, 0}, {u3, v / 0.3}, {u5, 0}, {u6, v / 0.35}});
}
constexpr auto parameters(double gravity) {
  return constant_parameters<System>({{WFrad, 0.35},
                                      {WRrad, 0.3},
                                      {htangle, 1.2566370614359172},
                                      {forkoffset, 0.03207142672761931},
                                      {forklength, 0.26764450844768867},
                                      {framelength, 0.9534570696121847},
                                      {forkcg1, 0.10230731158060875},
                                      {forkcg3, 0.026100592803432483},
                                      {framecg1, 0.4779288114646079},
                                      {framecg3, 0.4707271515135145},
                                      {Iwr11, 0.0603},
                                      {Iwr22, 0.12},
                                      {Iwf11, 0.1405},
                                      {Iwf22, 0.28},
                                      {Ifork11, 0.05892},
                                      {Ifork22, 0.06},
                                      {Ifork33, 0.00708},
                                      {Ifork31, 0.00756},
                                      {Iframe11, 9.2},
                                      {Iframe22, 11},
                                      {Iframe33, 2.8},
                                      {Iframe31, -2.4},
                                      {mfork, 4},
                                      {mframe, 85},
                                      {mwf, 3},
                                      {mwr, 2},
                                      {bicycle::g, gravity}});
}

// For u2 and u5; the spin of the wheels is decoupled.
constexpr matrix M = eom::mass_matrix.constant(straight_ahead(5), parameters(9.81)).at({0, 2}, {0, 2});

// The dependence of the rates of u2 and u5 on lean and steer, or on their rates, among q1, q2, q5, u2, u3,
// u5.
constexpr matrix by(double v, double gravity, const int (&columns)[2]) {
  const auto both = lin::explicit_form.constant(straight_ahead(v), parameters(gravity));
  return -1.0 * (M * std::get<0>(both).at({3, 5}, columns));
}
constexpr matrix C1 = by(1, 0, {3, 5}), K0 = by(0, 1, {1, 2}), K2 = by(1, 0, {1, 2});

constexpr bool is(const matrix& found, const matrix& expected) {
  const double most = 1e-12 * largest_entry(expected);
  return largest_entry(found - expected) <= most;
}
static_assert(is(M,
                 numeric::by_rows({{80.81722, 2.319413322087091}, {2.319413322087091, 0.2978418819968555}})));
static_assert(is(C1,
                 numeric::by_rows({{0.0, 33.86641391492494}, {-0.8503564145697844, 1.6854039739755968}})));
static_assert(is(K0, numeric::by_rows({{-80.95, -2.5995168524987164},
                                       {-2.5995168524987164, -0.8032948845861769}})));
static_assert(is(K2, numeric::by_rows({{0.0, 76.59734589573222}, {0.0, 2.65431523794604}})));
static_assert(!is(K2, C1));

} // namespace benchmark

} // namespace
