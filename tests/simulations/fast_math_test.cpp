// Values that are not numbers are reported even with -ffast-math.
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

/// A value that the compiler must not know.
double none() {
  volatile double zero = 0;
  return zero / zero;
}

TEST(fast_math, does_not_hide_options_that_are_not_finite) {
  using namespace simulations;
  EXPECT_EQ(check_span({0, none()}), "the time span is not finite");
  EXPECT_EQ(check_span({none(), 1}), "the time span is not finite");
  EXPECT_EQ(check_positive(none(), "a tolerance", false), "a tolerance is not finite");
  EXPECT_EQ(check_output_every(none(), {0, 1}, 8), "the time between two samples is not finite");
  EXPECT_EQ(check_positive(none(), "a step size", true), "a step size is not finite");
  EXPECT_NE(check_output_times({0.5, none()}, {0, 1}), "");
  EXPECT_EQ(check_span({0, 1}) + check_positive(1e-6, "a tolerance", false) +
                check_output_every(0.1, {0, 1}, 8) + check_positive(0.1, "a step size", true) +
                check_output_times({0.5}, {0, 1}),
            "");
}

TEST(fast_math, does_not_hide_states_that_are_not_finite) {
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
