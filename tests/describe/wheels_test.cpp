// The contact points of wheels as words, compared with written points and with a builder.
#include <kanexpr/symbolic.hpp>
#include <kanexpr/wheels.hpp>
#include <models/bicycle.hpp>
#include <models/rolling_torus.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <random>

namespace {

using namespace kanexpr;
using Eigen::VectorXd;

void expect_same(model words, model written, int states, int parameters) {
  ASSERT_EQ(words.mistake(), "");
  ASSERT_EQ(written.mistake(), "");
  auto first = words.function(words.rhs()), second = written.function(written.rhs());
  std::mt19937_64 source(7);
  std::uniform_real_distribution<double> values(0.1, 0.9);
  for (int i = 0; i < 10; ++i) {
    const VectorXd state = VectorXd::NullaryExpr(states, [&] { return values(source); });
    const VectorXd p = VectorXd::NullaryExpr(parameters, [&] { return values(source); });
    EXPECT_LT((first(state, p) - second(state, p)).norm(), 1e-11 * second(state, p).norm());
  }
}

namespace torus {
using namespace rolling_torus;
struct Contact : contact_point<Contact, toroidal_wheel<by_rates::G, L::y, R, a, by_rates::B>,
                               flat_ground<by_rates::O, 3 * N::z>> {};
struct Words : lagrange_system<inertial<N>, coordinates<q1, q2, q3, by_rates::q4, by_rates::q5>,
                               velocity_constraints<zero_along<velocity_of<Contact>, N::x, N::y>>,
                               dependent<dot(by_rates::q4), dot(by_rates::q5)>, bodies<by_rates::Torus>,
                               loads<gravity<-g * N::z>>> {};
} // namespace torus

TEST(contact_points, of_a_torus_roll_as_in_the_textbook) {
  expect_same(derive<torus::Words>(), derive<rolling_torus::LagrangeSystem>(), 10, 4);
}

namespace front {
using namespace bicycle;
struct Contact : contact_point<Contact, thin_wheel<WF_mc, Fork::y, WFrad, WF>, flat_ground<WR_cont, Y::z>> {};
struct Words : kane_system<inertial<N>, coordinates<q1, q2, q5, q4>, speeds<u2, u3, u5, u1, u4, u6>,
                           kinematics<dot(q1) == u1, dot(q2) == u2, dot(q4) == u4, dot(q5) == u5>,
                           configuration_constraints<dot(position_of<Contact, WR_cont>, Y::z) == 0>,
                           velocity_constraints<zero_along<velocity_of<Contact>, Y::x, Y::y, Y::z>>,
                           dependent<u1, u4, u6, q4>, bodies<BodyFrame, BodyFork, BodyWR, BodyWF>,
                           loads<gravity<-g * N::z>>> {};
} // namespace front

TEST(contact_points, of_a_bicycle_are_the_written_ones) {
  expect_same(derive<front::Words>(), derive<bicycle::System>(), 10, 27);
}

} // namespace
