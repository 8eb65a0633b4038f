// builds: clang++ all
// Tyres, muscles and friction with bristles in everything that moves a system: batches, steps, filters,
// simulations and ensembles, compared with interpreted rates.
#include "runtime/agreement.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/blocks.hpp>
#include <kanexpr/compiled/constant_values.hpp>
#include <kanexpr/control.hpp>
#include <kanexpr/ensemble.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulations/model.hpp>

#include <models/appell_hamel.hpp>
#include <models/cornering_car.hpp>
#include <models/stick_slip.hpp>

#include <docs/guide/muscles/elbow.cpp>

#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace kanexpr;

/// A system at a state, which moves in steps of the length h.
template <class System>
struct motion {
  using eom = equations_of_motion<System>;
  using step = runge_kutta_4<System>;
  static constexpr int states = eom::state::SizeAtCompileTime;

  typename eom::state x{};
  typename eom::parameters p{};
  typename eom::inputs r{};
  double h = 0;
  model m = derive<System>();
  runtime::interpreted<double> rates = m.function(m.rhs());

  Eigen::VectorXd rate(double t, const Eigen::VectorXd& at) { return rates(t, at, p, r); }

  /// A step of the method of Runge and Kutta with interpreted rates.
  Eigen::VectorXd next(double t, const Eigen::VectorXd& at) {
    const Eigen::VectorXd first = rate(t, at), second = rate(t + h / 2, at + h / 2 * first),
                          third = rate(t + h / 2, at + h / 2 * second), fourth = rate(t + h, at + h * third);
    return at + h / 6 * (first + 2 * second + 2 * third + fourth);
  }
  typename eom::state other() const {
    typename eom::state moved = x;
    moved(1) += 0.01;
    return moved;
  }
};

template <class System>
void moves_in_batches_and_in_single_precision(motion<System> of) {
  using eom = equations_of_motion<System>;
  const auto rhs = [&](const auto& x) {
    if constexpr (requires { eom::rhs(0.0, x, of.p, of.r); })
      return eom::rhs(0.3, x, of.p, of.r);
    else
      return eom::rhs(x, of.p, of.r);
  };
  agreement::expect_same_bits(rhs(of.x), of.rate(0.3, of.x));
  using two = batch<2>;
  typename two::template state<System> both;
  two::set(both, 0, of.x), two::set(both, 1, of.other());
  const auto found = rhs(both);
  EXPECT_EQ(two::get(found, 0), rhs(of.x));
  EXPECT_EQ(two::get(found, 1), rhs(of.other()));

  auto single = of.m.template function<float>(of.m.rhs());
  const auto x = of.x.template cast<float>().eval();
  const auto p = of.p.template cast<float>().eval();
  const auto r = of.r.template cast<float>().eval();
  const auto rounded = [&] {
    if constexpr (requires { eom::rhs(0.0F, x, p, r); })
      return eom::rhs(0.3F, x, p, r);
    else
      return eom::rhs(x, p, r);
  }();
  const auto interpreted = single(0.3F, x, p, r);
  for (int i = 0; i < motion<System>::states; ++i) EXPECT_EQ(rounded(i), interpreted(i)) << i;
}

/// One step of many systems, one of a filter and some of an ensemble.
template <class System>
void moves_in_steps(motion<System> of) {
  using step = typename motion<System>::step;
  auto x = of.x;
  Eigen::VectorXd expected = of.x;
  double t = 0;
  for (int k = 0; k < 20; ++k) {
    expected = of.next(t, expected);
    ASSERT_TRUE(step{}(t, x, of.h, of.p, of.r));
  }
  EXPECT_LE((x - expected).norm(), 1e-12 * expected.norm());

  many<state<System>> side_by_side(3);
  for (int j = 0; j < 3; ++j) side_by_side.set(j, of.x);
  side_by_side.set(1, of.other());
  rollout<step> ahead(3, {.step = of.h, .steps = 20});
  ASSERT_TRUE(ahead.run(side_by_side, of.p, of.r));
  EXPECT_EQ(side_by_side.get(0), x);
  EXPECT_EQ(side_by_side.get(2), x);
  EXPECT_NE(side_by_side.get(1), x);
}

/// The covariance that a filter predicts is that of the matrix exponential of A.
template <class System, auto measured>
void is_filtered(motion<System> of) {
  using square = Eigen::Matrix<double, motion<System>::states, motion<System>::states>;
  ekf<System, measured> filter(of.x, square::Identity());
  ASSERT_TRUE(filter.predict(0, of.h, of.p, of.r, square::Zero().eval()));
  model m = derive<System>();
  auto state_matrix = m.function(m.get(mechanics::quantity::state_matrix));
  const Eigen::MatrixXd A = state_matrix(0.0, of.x, of.p, of.r);
  const Eigen::MatrixXd exponential = (A * of.h).exp();
  const Eigen::MatrixXd expected = exponential * exponential.transpose();
  EXPECT_LE((filter.P - expected).norm(), 1e-12 * expected.norm());
  EXPECT_LE((filter.x - of.next(0, of.x)).norm(), 1e-12 * filter.x.norm());
}

std::vector<named_value> numbers(double standstill) {
  using namespace cornering_car;
  return {{m, 1500}, {J, 2400},  {g, 9.81},  {a, 1.2}, {b, 1.6},        {R, 0.3},
          {mu, 0.9}, {C_f, 9e4}, {C_r, 1e5}, {s, 0.4}, {v0, standstill}};
}

motion<cornering_car::System> of_car() {
  using namespace cornering_car;
  motion<System> of;
  of.x << 0, 0, 0.1, 0, 0, 20, -0.4, 0.3, 66.2, 67.5, 0.001, -0.004, 0.002, -0.003;
  of.p = given_parameters<cornering_car::System>(numbers(0.1)).values;
  of.r = {{delta, 0.05}, {dot(delta), 0}, {dot(dot(delta)), 0}, {T, 100}};
  of.h = 1e-3;
  return of;
}

motion<elbow::System> of_elbow() {
  using namespace elbow;
  motion<System> of;
  of.x = {{q, 0.2}, {u, -0.3}, {Biceps::activation, 0.4}, {Biceps::tendon_force, 0.35}};
  of.p = {{m, 1.5}, {J, 0.01}};
  of.r = {{e, 0.6}};
  of.h = 1e-4;
  return of;
}

motion<stick_slip::System> of_block() {
  using namespace stick_slip;
  motion<System> of;
  of.x = {{x, 0.02}, {v, 0.1}, {bristle, 1e-4}};
  of.p = {{m, 1},  {k, 2},      {l, 0.1},      {V, 0.1},      {Fs, 1.5},
          {Fc, 1}, {vs, 0.001}, {sigma0, 1e5}, {sigma1, 300}, {sigma2, 0.4}};
  of.h = 1e-5;
  return of;
}

// The constraint of Appell and Hamel, which is not linear in the speeds.
motion<appell_hamel::System> of_particle() {
  using namespace appell_hamel;
  motion<System> of;
  of.x << 0.1, 0.2, 0.3, 0.6, -0.8, 2;
  of.p = {{m, 1.3}, {a, 0.5}, {g, 9.81}};
  of.r = {{F, 0.4}};
  return of;
}

TEST(loads, move_systems_in_batches_and_in_single_precision) {
  moves_in_batches_and_in_single_precision(of_car());
  moves_in_batches_and_in_single_precision(of_elbow());
  moves_in_batches_and_in_single_precision(of_block());
  moves_in_batches_and_in_single_precision(of_particle());
}

TEST(loads, move_systems_in_steps) {
  moves_in_steps(of_car());
  moves_in_steps(of_elbow());
  moves_in_steps(of_block());
}

TEST(loads, are_filtered) {
  is_filtered<cornering_car::System, cornering_car::r>(of_car());
  is_filtered<elbow::System, elbow::q>(of_elbow());
  is_filtered<stick_slip::System, stick_slip::x>(of_block());
}

// An ensemble keeps what simulations of the interpreted model find, to the last bit.
TEST(loads, act_in_ensembles) {
  using namespace cornering_car;
  std::vector<named_value> start{{x, 0}, {y, 0}, {psi, 0},         {front_angle, 0}, {rear_angle, 0},
                                 {v, 0}, {r, 0}, {front_spin, 60}, {rear_spin, 60}};
  const study<System> told{
      .runs = grid({{u, {15, 20}}, {delta, {0.02, 0.05}}}),
      .state = start,
      .parameters = numbers(0.1),
      .inputs = {{dot(delta), 0}, {dot(dot(delta)), 0}, {T, 100}},
      .span = {0, 0.5},
      .keep = {at_end<r>("yaw_rate"), at_end<lateral_deflection_of<FrontHub>>("deflection")}};
  const auto found = ensemble<System>(told).run({.threads = 2});
  ASSERT_TRUE(found) << found.cause();
  ASSERT_EQ(found.failed, 0u);
  start.push_back({u, 0});
  for (std::size_t k = 0; k < 4; ++k) {
    start.back() = {u, found.runs["u"][k]};
    const auto alone =
        simulate(derive<System>(), start, numbers(0.1), {0, 0.5},
                 {.inputs = {{"delta", found.runs["delta"][k]}, {"delta'", 0}, {"delta''", 0}, {"T", 100}}});
    ASSERT_TRUE(alone) << alone.cause();
    EXPECT_EQ(found.runs["yaw_rate"][k], alone.state["r"]);
    EXPECT_EQ(found.runs["deflection"][k], alone.state["dy_FrontHub"]);
    EXPECT_GT(found.runs["yaw_rate"][k], 0.05);
  }
}

// In the limit of small angles, the car turns with the yaw rate of the linear theory.
TEST(loads, hold_a_car_in_a_steady_turn) {
  using namespace cornering_car;
  const operating_point<System> gentle(
      {{u, 20}, {front_spin, 20 / 0.3}, {rear_spin, 20 / 0.3}}, numbers(1e-4),
      {.inputs = {{delta, 1e-8}}, .held = {u}, .changing = {x, y, psi, front_angle, rear_angle}});
  ASSERT_TRUE(gentle) << gentle.cause();
  EXPECT_EQ(gentle.freedom, 5) << "the place, the heading and the angles of the wheels";
  const double base = 1.2 + 1.6, understeer = 1500 * (1.6 * 1e5 - 1.2 * 9e4) / (base * base * 9e4 * 1e5);
  const double yaw_rate = 20 * 1e-8 / (base * (1 + understeer * 400));
  EXPECT_NEAR(gentle.x[r], yaw_rate, 1e-9 * yaw_rate);

  // At 0.51 of the weight, from the balance of forces and the brush model.
  const operating_point<System> turn({{u, 20}, {r, 0.25}, {front_spin, 20 / 0.3}, {rear_spin, 20 / 0.3}},
                                     numbers(1e-3),
                                     {.inputs = {{delta, 0.05}},
                                      .held = {u, r},
                                      .freed = {delta},
                                      .changing = {x, y, psi, front_angle, rear_angle}});
  ASSERT_TRUE(turn) << turn.cause();
  EXPECT_EQ(turn.freedom, 5);
  const double steered = turn.r[delta], side = turn.x[v], spin = turn.x[rear_spin];
  const double front = 1500 * 20 * 0.25 * 1.6 / base / std::cos(steered),
               rear = 1500 * 20 * 0.25 * 1.2 / base;
  const double push = front * std::sin(steered) - 1500 * side * 0.25;
  EXPECT_NEAR(turn.r[T], 0.3 * push, 1e-9 * push);
  const auto force = [](double stiffness, double load, double slip) { // Pacejka (2012), section 3.2
    const double limit = 0.9 * load, adhesion = 1 - stiffness * slip / (3 * limit);
    return limit * (1 - adhesion * adhesion * adhesion);
  };
  const double ahead = 20 * std::cos(steered) + (side + 1.2 * 0.25) * std::sin(steered),
               left = (side + 1.2 * 0.25) * std::cos(steered) - 20 * std::sin(steered);
  EXPECT_NEAR(force(9e4, 1500 * 9.81 * 1.6 / base, -left / ahead), front, 1e-6 * front);
  const double slips = spin * 0.3 - 20, slides = 1.6 * 0.25 - side;
  EXPECT_NEAR(force(1e5, 1500 * 9.81 * 1.2 / base, std::hypot(slips, slides) / (0.3 * spin)),
              std::hypot(rear, push), 1e-6 * rear);
  EXPECT_NEAR(slides / slips, rear / push, 1e-8 * rear / push);
}

// Bristles carry a block that a spring pulls, and a muscle a forearm.
TEST(loads, hold_blocks_and_forearms) {
  using namespace stick_slip;
  const operating_point<System> block({{x, 0.01}},
                                      {{m, 1},
                                       {k, 2},
                                       {l, 0.1},
                                       {V, 0},
                                       {Fs, 1.5},
                                       {Fc, 1},
                                       {vs, 0.001},
                                       {sigma0, 1e5},
                                       {sigma1, 300},
                                       {sigma2, 0.4}},
                                      {.held = {x}});
  ASSERT_TRUE(block) << block.cause();
  EXPECT_NEAR(block.x[bristle], -2 * 0.01 / 1e5, 1e-19);
  EXPECT_EQ(block.freedom, 0);

  using elbow::Biceps;
  const operating_point<elbow::System> arm(
      {{elbow::q, 0}, {Biceps::activation, 0.3}, {Biceps::tendon_force, 0.3}},
      {{elbow::m, 1.5}, {elbow::J, 0.01}}, {.held = {elbow::q}});
  ASSERT_TRUE(arm) << arm.cause();
  const muscle_at_rest rest =
      muscle_equilibrium(elbow::biceps, std::hypot(0.3, 0.04), arm.x[Biceps::activation]);
  EXPECT_NEAR(arm.x[Biceps::tendon_force], rest.tendon_force, 1e-11);
}

// The rates of a car, while this file is compiled.
constexpr auto car_rates = [] {
  using namespace cornering_car;
  return equations_of_motion<System>::rhs.constant(
      constant_state<System>({{x, 0},
                              {y, 0},
                              {psi, 0.1},
                              {front_angle, 0},
                              {rear_angle, 0},
                              {u, 20},
                              {v, -0.4},
                              {r, 0.3},
                              {front_spin, 66.2},
                              {rear_spin, 67.5},
                              {forward_deflection_of<FrontHub>, 0.001},
                              {lateral_deflection_of<FrontHub>, -0.004},
                              {forward_deflection_of<RearHub>, 0.002},
                              {lateral_deflection_of<RearHub>, -0.003}}),
      constant_parameters<System>({{m, 1500},
                                   {J, 2400},
                                   {g, 9.81},
                                   {a, 1.2},
                                   {b, 1.6},
                                   {R, 0.3},
                                   {mu, 0.9},
                                   {C_f, 9e4},
                                   {C_r, 1e5},
                                   {s, 0.4},
                                   {v0, 0.1}}),
      constant_inputs<System>({{delta, 0.05}, {dot(delta), 0}, {dot(dot(delta)), 0}, {T, 100}}));
}();
static_assert(car_rates(6) < 0, "the tyres turn the car to the right");

TEST(loads, act_in_constant_expressions) {
  motion<cornering_car::System> of = of_car();
  const Eigen::VectorXd expected = of.rate(0, of.x);
  for (int i = 0; i < 14; ++i)
    EXPECT_NEAR(car_rates(i), expected(i), 1e-13 * (1 + std::abs(expected(i)))) << i;
}

} // namespace
