// What is not a number is told with -ffast-math too.
#include <kanexpr/simulations/check_options.hpp>
#include <kanexpr/steps/assemble.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr;

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"vx"> vx;
constexpr speed<"vy"> vy;
constexpr parameter<"l"> l;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x + y * N::y> {};
struct Bead : particle<Bead, P, 1> {};
struct System
    : kane_system<inertial<N>, coordinates<x, y>, speeds<vx, vy>, kinematics<dot(x) == vx, dot(y) == vy>,
                  configuration_constraints<x * x + y * y == l * l>, bodies<Bead>> {};

/// What the compiler must not know.
double none() {
  volatile double zero = 0;
  return zero / zero;
}

TEST(fast_math, tells_what_is_not_finite_of_simulations) {
  using namespace simulations;
  EXPECT_EQ(check_span({0, none()}), "the time span is not finite");
  EXPECT_EQ(check_span({none(), 1}), "the time span is not finite");
  EXPECT_EQ(check_tolerance(none()), "a tolerance is not finite");
  EXPECT_EQ(check_output_every(none(), {0, 1}, 8), "the time between two samples is not finite");
  EXPECT_EQ(check_step(none()), "a step size is not finite");
  EXPECT_NE(check_output_times({0.5, none()}, {0, 1}), "");
  EXPECT_EQ(check_span({0, 1}) + check_tolerance(1e-6) + check_output_every(0.1, {0, 1}, 8) +
                check_step(0.1) + check_output_times({0.5}, {0, 1}),
            "");
}

TEST(fast_math, tells_what_is_not_finite_of_states) {
  const auto cause = [](double length, double at) {
    return std::string(check_consistency(state<System>{{x, at}, {y, 0}, {vx, 0}, {vy, 0}},
                                         parameter_values<System>{{l, length}})
                           .cause());
  };
  EXPECT_EQ(cause(1, 1), "");
  EXPECT_NE(cause(1, none()), "");
  EXPECT_EQ(cause(none(), 1), "the value of parameter l is not a number");
  state<System> start{{x, 1}, {y, 0}, {vx, 0}, {vy, 0}};
  EXPECT_FALSE(assemble(start, parameter_values<System>{{l, none()}}));
  EXPECT_EQ(start[x], 1);
}

} // namespace
