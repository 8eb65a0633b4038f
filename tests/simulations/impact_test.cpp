// builds: clang++ all
// Impacts as events, compared with closed forms.
#include "simulations/falling_ball.hpp"

#include <kanexpr/numeric/impulses.hpp>
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/events/impact.hpp>

#include <Eigen/Core>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace {

using namespace kanexpr;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(impact, of_a_ball) {
  using namespace falling_ball;
  const auto fall = [](double e, double rest_speed, double end) {
    const auto hit = when<System, dot(position_of<P, O>, N::z)>("hit", crossing::falling,
                                                                impact<System, h>(e, rest_speed));
    return simulate<System>({{h, 1}, {v, 0}}, {{m, 2}, {g, 9.81}}, {0, end},
                            {.relative_tolerance = 1e-12, .events = {hit}});
  };
  const double drop = std::sqrt(2 / 9.81), speed = 9.81 * drop;
  const auto once = fall(0.6, 0, 1.4 * drop);
  ASSERT_TRUE(once) << once.cause();
  EXPECT_NEAR(once.state[v], 0.6 * speed - 9.81 * 0.4 * drop, 1e-9);
  const auto rest = fall(0.6, 1e-3, 10); // it rests after (1 + 2 e/(1 − e)) times the drop
  EXPECT_TRUE(rest.stopped_by_event);
  EXPECT_NEAR(rest.events.back().t, drop * (1 + 2 * 0.6 / 0.4), 1e-3);
  const auto endless = fall(0.6, 0, 10);
  EXPECT_FALSE(endless);
  EXPECT_THAT(std::string(endless.cause()), testing::HasSubstr("events occur faster and faster"));
  EXPECT_THAT(std::string(fall(1.2, 0, 10).cause()),
              testing::HasSubstr("restitution 1.200000 is not in [0, 1]"));
}

// A rod in a plane, and two walls.
namespace rod {

constexpr coordinate<"x"> x;
constexpr coordinate<"z"> z;
constexpr coordinate<"q"> q;
constexpr speed<"vx"> vx;
constexpr speed<"vz"> vz;
constexpr speed<"w"> w;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct B : rotated<B, N, q, N::y> {};
struct C : offset<C, O, x * N::x + z * N::z> {};
struct Left : offset<Left, C, -0.5 * B::x> {};
struct Right : offset<Right, C, 0.5 * B::x> {};
struct Rod : rigid_body<Rod, C, B, 3, inertia<B, 0.25, 0.25, 0.25>> {};
struct System : kane_system<inertial<N>, coordinates<x, z, q>, speeds<vx, vz, w>,
                            kinematics<dot(x) == vx, dot(z) == vz, dot(q) == w>, bodies<Rod>> {};
/// The same, sliding without turning.
struct Guided : kane_system<inertial<N>, coordinates<x, z, q>, speeds<vx, vz, w>,
                            kinematics<dot(x) == vx, dot(z) == vz, dot(q) == w>, bodies<Rod>,
                            velocity_constraints<w == 0>> {};

constexpr auto left = dot(position_of<Left, O>, N::z), right = dot(position_of<Right, O>, N::z);

template <class Of>
VectorXd speeds_after(double angle, double e) {
  state<Of> at;
  at << 0, 0.5 * std::abs(std::sin(angle)), angle, 0.3, -2, 0;
  const parameter_values<Of> p;
  const input_values<Of> r;
  moment<Of> now{0, at, p, r};
  impact<Of, left, right>{e}(now);
  return at.tail(3);
}

} // namespace rod

TEST(impact, of_a_rod) {
  // J = (1 + e) m v/(1 + m a²/I) at an end at the distance a = 0.5 cos q
  const double a = 0.5 * std::cos(0.4), impulse = 1.7 * 2 / (1 / 3.0 + a * a / 0.25);
  const VectorXd one = rod::speeds_after<rod::System>(0.4, 0.7); // the right end is lower
  EXPECT_NEAR(one[0], 0.3, 1e-14);
  EXPECT_NEAR(one[1], -2 + impulse / 3, 1e-12);
  EXPECT_NEAR(one[2], -impulse * a / 0.25, 1e-12);
  const VectorXd both = rod::speeds_after<rod::System>(0, 0.7); // flat: it does not turn
  EXPECT_LT((both - Eigen::Vector3d(0.3, 1.4, 0)).norm(), 1e-12);
  const VectorXd guided = rod::speeds_after<rod::Guided>(0.4, 0.7);
  EXPECT_LT((guided - Eigen::Vector3d(0.3, 1.4, 0)).norm(), 1e-12);
}

// Newton's law at all contacts, impulses that push, and no energy from nothing, also with dependent contacts.
TEST(impact, of_several_contacts) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> between(-1, 1);
  const auto draw = [&](Eigen::Index rows, Eigen::Index columns) {
    return MatrixXd(MatrixXd::NullaryExpr(rows, columns, [&] { return between(random); }));
  };
  for (int round = 0; round < 300; ++round) {
    const MatrixXd root = draw(5, 5), mass = root * root.transpose() + 0.1 * MatrixXd::Identity(5, 5);
    const MatrixXd constraints = draw(1, 5);
    MatrixXd contacts = draw(1 + round % 4, 5);
    if (round % 3 == 0 && contacts.rows() > 1) contacts.row(1) = 2 * contacts.row(0);
    VectorXd u = draw(5, 1);
    u -= constraints.transpose() * (constraints * u) / constraints.squaredNorm();
    const double e = round % 5 == 0 ? 1.0 : 0.5 * (1 + between(random));
    const VectorXd after = numeric::struck_contacts(mass, constraints, contacts).speeds_after(u, e);
    EXPECT_LT(std::abs((constraints * after)(0)), 1e-9);
    EXPECT_GE((contacts * (after + e * u)).minCoeff(), -1e-9);
    EXPECT_LE(after.dot(mass * after), u.dot(mass * u) * (1 + 1e-9));
    if ((contacts * u).minCoeff() >= 0) {
      EXPECT_LT((after - u).norm(), 1e-9);
    }
  }
}

} // namespace
