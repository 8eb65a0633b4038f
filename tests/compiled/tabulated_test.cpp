// builds: clang++
// A motor whose torque is tabulated over its speed, and a spring whose tabulated forces are parameters.

#include <kanexpr/batch.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic.hpp>

#include "models/simple_pendulum.hpp"

#include <unsupported/Eigen/AutoDiff>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace simple_pendulum;

constexpr double pi = 3.141592653589793;
constexpr parameter<"k1"> k1;
constexpr parameter<"k2"> k2;
constexpr auto motor = tabulated<0, 3, 2, 2.5, 4, 1, 5, 0>;
constexpr auto spring_torque = tabulated<-1, -k2, -0.5, -k1, 0, 0, 0.5, k1, 1, k2>;

struct Driven : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            parameters<m, l, g, k1, k2>, bodies<Bob>,
                            loads<gravity<g * N::x>, torque<A, (motor(abs(u)) - spring_torque(q)) * N::z>>> {
};

using eom = equations_of_motion<Driven>;

const eom::parameters numbers{{m, 1}, {l, 1}, {g, 0}, {k1, 2}, {k2, 8}};

template <class S>
auto compiled(const S& angle, const S& speed) {
  kanexpr::state<Driven, S> x;
  x[q] = angle;
  x[u] = speed;
  const kanexpr::parameter_values<Driven, S> p(numbers.cast<S>());
  return eom::udot(x, p);
}

/// At points of both tables, and halfway between points at −½.
TEST(tabulated, is_that_of_every_scalar_type) {
  const auto udot = compiled(0.5, -2.0);
  EXPECT_TRUE(udot.status);
  EXPECT_NEAR(udot(0), 2.5 - 2, 1e-15);
  EXPECT_NEAR(compiled(-7.0, 9.0)(0), 8, 1e-15);
  EXPECT_NEAR(compiled(0.25F, 1.0F)(0), compiled(0.25, 1.0)(0), 1e-6);
  EXPECT_NEAR(static_cast<double>(compiled(0.25L, 1.0L)(0)), compiled(0.25, 1.0)(0), 1e-15);
  using number = Eigen::AutoDiffScalar<Eigen::Vector2d>;
  const Eigen::Vector2d slopes = compiled(number(0.25, 2, 0), number(-1.0, 2, 1))(0).derivatives();
  constexpr double step = 1e-6;
  EXPECT_NEAR(slopes(0), (compiled(0.25 + step, -1.0)(0) - compiled(0.25 - step, -1.0)(0)) / (2 * step),
              1e-8);
  EXPECT_NEAR(slopes(1), (compiled(0.25, -1.0 + step)(0) - compiled(0.25, -1.0 - step)(0)) / (2 * step),
              1e-8);
  const auto linear = linearization<Driven>::explicit_form(eom::state{{q, 0.25}, {u, -1}}, numbers);
  EXPECT_NEAR(std::get<0>(linear)(1, 0), slopes(0), 1e-13);
  EXPECT_NEAR(std::get<0>(linear)(1, 1), slopes(1), 1e-13);
}

TEST(tabulated, is_read_lane_by_lane) {
  using side_by_side = batch<2>;
  for (const double at : {-0.7, 0.1}) {
    side_by_side::state<Driven> x;
    for (std::size_t lane = 0; lane < side_by_side::lanes; ++lane) {
      const double along = 0.4 * static_cast<double>(lane) + at;
      side_by_side::set(x, lane, {{q, along}, {u, 4.75 * (along + 0.7)}});
    }
    const auto udot = eom::udot(x, numbers);
    for (std::size_t lane = 0; lane < side_by_side::lanes; ++lane)
      EXPECT_EQ(udot(0)[lane], eom::udot(side_by_side::get(x, lane), numbers)(0));
  }
}

TEST(tabulated, is_a_constant_and_is_interpreted) {
  constexpr auto udot = eom::udot.constant({0.25, -1}, {1, 1, 0, 2, 8});
  EXPECT_NEAR(udot(0), compiled(0.25, -1.0)(0), 1e-15);
  auto system = derive<Driven>();
  auto f = system.function(system.udot());
  for (const double speed : {-6.0, -2.0, 0.0, 0.3, 4.5})
    EXPECT_EQ(f(Eigen::Vector2d(0.3, speed), Eigen::VectorXd(numbers))(0), compiled(0.3, speed)(0));
}

constexpr parameter<"x1"> x1;

struct Sprung
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, x1>,
                  bodies<Bob>, loads<torque<A, tabulated<0, 0, x1, 1, 2, 2>(q) * N::z>>> {};

/// A function of the angle with a period of one turn.
struct Cogging
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l>,
                  bodies<Bob>, loads<torque<A, periodic<-pi, 0, -1, 2, 0.5, -1, pi, 0>(q) * N::z>>> {};

TEST(tabulated, begins_anew) {
  using cogging = equations_of_motion<Cogging>;
  const cogging::parameters one{{m, 1}, {l, 1}};
  for (const double angle : {-3.1, -1.0, 0.3, 3.0}) {
    const cogging::state x{{q, angle}, {u, 0}}, turned{{q, angle + 4 * pi}, {u, 0}};
    EXPECT_NEAR(cogging::udot(x, one)(0), cogging::udot(turned, one)(0), 1e-14);
    const auto [A, B] = linearization<Cogging>::explicit_form(x, one);
    constexpr double step = 1e-6;
    const cogging::state before{{q, angle - step}, {u, 0}}, behind{{q, angle + step}, {u, 0}};
    EXPECT_NEAR(A(1, 0), (cogging::udot(behind, one)(0) - cogging::udot(before, one)(0)) / (2 * step), 1e-4);
  }
  constexpr auto cost = cogging::cost(cogging::udot);
  EXPECT_EQ(cost.trigonometric, 2);
}

/// There is no slope between points that coincide.
TEST(tabulated, with_parameters_has_a_status) {
  using sprung = equations_of_motion<Sprung>;
  const sprung::state x{{q, 1.5}, {u, 0}};
  EXPECT_TRUE(sprung::udot(x, sprung::parameters{{m, 1}, {l, 1}, {x1, 1}}).status);
  EXPECT_FALSE(sprung::udot(x, sprung::parameters{{m, 1}, {l, 1}, {x1, 2}}).status);
}

} // namespace
