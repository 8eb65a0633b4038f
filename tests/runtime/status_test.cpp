// builds: clang++
// Equations that cannot be solved: compiled and run-time systems report the same status.
#include "four_bars.hpp"
#include "models/rolling_disc_constrained.hpp"
#include "models/simple_pendulum.hpp"

#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

/// The four-bar linkage, with its loop closed along different directions.
namespace four_bar {
struct TurnedSystem
    : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                  kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3>,
                  configuration_constraints<zero_along<position_of<P3, Bearing>, N::x + N::y, N::x - N::y>>,
                  dependent<q2, q3, u2, u3>, inputs<T>, bodies<Crank, Coupler, Rocker>,
                  loads<gravity<-g * N::y>, torque<A, T * N::z>>> {};
} // namespace four_bar

/// A top whose speeds are the rates of its angles, with numbers or symbols.
namespace gimbal {
using namespace kanexpr;
constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr coordinate<"q3"> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
struct N : inertial_frame<N> {};
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::x> {};
struct C : rotated<C, B, q3, B::z> {};
struct O : origin<O, N> {};
struct G : offset<G, O, rational<1, 2> * C::z> {};
struct Top : rigid_body<Top, G, C, 2, inertia<C, 1, 2, 3>> {};
struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                            kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3>, bodies<Top>> {};
} // namespace gimbal

/// Two rods with numbers, without singular configurations.
namespace two_rods {
using namespace kanexpr;
constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
struct N : inertial_frame<N> {};
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::y> {};
struct O : origin<O, N> {};
struct P : offset<P, O, 2 * A::x> {};
struct Q : offset<Q, P, B::x> {};
struct Upper : rigid_body<Upper, P, A, 1, inertia<A, 0, 1, 1>> {};
struct Lower : particle<Lower, Q, 3> {};
struct System : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>,
                            kinematics<dot(q1) == u1, dot(q2) == u2>, bodies<Upper, Lower>> {};
} // namespace two_rods

/// A pendulum whose moment of inertia has no reciprocal that is a double.
namespace light_pendulum {
using namespace simple_pendulum;
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            values<m == 1e-309, l == 1>, inputs<T>, bodies<Bob>, loads<torque<A, T * N::z>>> {
};
} // namespace light_pendulum

/// Beads on parallel wires, described by angles that become singular at right angles.
namespace beads {
using namespace kanexpr;
constexpr int count = 36;
template <int i>
constexpr coordinate<"q", i> q;
template <int i>
constexpr speed<"u", i> u;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
template <int i>
struct P : offset<P<i>, O, q<i> * N::x> {};
template <int i>
struct Bead : particle<Bead<i>, P<i>, 1> {};
template <int... i>
using system_of = kane_system<inertial<N>, coordinates<q<i>...>, speeds<u<i>...>,
                              kinematics<cos(q<i>) * dot(q<i>) == u<i>...>, bodies<Bead<i>...>>;
template <int... i>
system_of<i...> all(std::integer_sequence<int, i...>);
struct System : decltype(all(std::make_integer_sequence<int, count>{})){};
} // namespace beads

/// A bead in a plane, on a spring to a point outside of the plane, with a force that is undefined at x = 0.
namespace pushed_bead {
using namespace kanexpr;
constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"u"> u;
constexpr speed<"v"> v;
constexpr parameter<"m"> m;
constexpr parameter<"k"> k;
constexpr parameter<"l"> l;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct Q : offset<Q, O, 3 * N::x> {};
struct P : offset<P, O, x * N::x + y * N::y> {};
struct Bead : particle<Bead, P, m> {};
struct System
    : kane_system<inertial<N>, coordinates<x, y>, speeds<u, v>, kinematics<dot(x) == u, dot(y) == v>,
                  bodies<Bead>, loads<spring<P, Q, k, l>, force<P, k * log(x) * N::x>>> {};
} // namespace pushed_bead

/// A bead on a rotating table with two slides, with numbers.
namespace turntable {
using namespace kanexpr;
constexpr coordinate<"q"> q;
constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"w"> w;
constexpr speed<"u"> u;
constexpr speed<"v"> v;
struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * A::x + y*(A::x + 2 * A::y + A::z)> {};
struct Table : rigid_body<Table, O, A, 1, inertia<A, 1, 1, 2>> {};
struct Bead : particle<Bead, P, 1> {};
struct System : kane_system<inertial<N>, coordinates<q, x, y>, speeds<w, u, v>,
                            kinematics<dot(q) == w, dot(x) == u, dot(y) == v>, bodies<Table, Bead>> {};
} // namespace turntable

namespace {

using kanexpr::mechanics::quantity;

// The status of ẋ of both systems.
template <class System, class X, class P, class R>
void expect_status(const X& x, const P& p, const R& r, const std::string& cause) {
  using eom = kanexpr::equations_of_motion<System>;
  auto derived = kanexpr::derive<System>();
  auto interpreted = derived.function(derived.rhs());
  interpreted(x, p, r);
  for (const kanexpr::status& s : {eom::rhs(x, p, r).status, interpreted.status()}) {
    EXPECT_EQ(static_cast<bool>(s), cause.empty());
    EXPECT_EQ(s.cause(), cause);
  }
}

TEST(status, is_good_at_regular_states) {
  const four_bars b;
  expect_status<four_bars::System>(b.x, b.p, b.r, "");
}

TEST(status, names_speeds_that_cannot_be_solved_for) {
  four_bars b;
  b.x[four_bar::q3] = 0; // coupler and rocker in line
  expect_status<four_bars::System>(
      b.x, b.p, b.r, "the constraints cannot be solved for the dependent speeds u2 and u3 at this state");
  b.x[four_bar::q3] = 1e-6; // nearly
  expect_status<four_bars::System>(b.x, b.p, b.r, "");
}

// Closer to the position in which coupler and rocker are in line, rounding exceeds a millionth of u̇.
TEST(status, lets_no_more_than_a_millionth_of_error_through) {
  const auto exactly = [](const auto& given) {
    return Eigen::Matrix<long double, std::remove_cvref_t<decltype(given)>::SizeAtCompileTime, 1>(
        given.template cast<long double>());
  };
  int good = 0;
  for (double angle = 1e-2; angle > 1e-16; angle /= 3) {
    four_bars b;
    b.x[four_bar::q3] = angle;
    const auto udot = four_bars::eom::udot(b.x, b.p, b.r);
    if (!udot.status) continue;
    ++good;
    const auto exact = four_bars::eom::udot(exactly(b.x), exactly(b.p), exactly(b.r));
    EXPECT_LE((exactly(udot) - exact).norm(), 1e-6L * exact.norm()) << angle;
  }
  EXPECT_GT(good, 15); // down to 1e-9 or so
  EXPECT_LT(good, 25);
}

// A parallelogram with all bars in line can move in more than one way: its dependent speeds do not determine
// u̇.
TEST(status, does_not_rest_on_what_vanishes_with_a_constraint) {
  four_bars b;
  using namespace four_bar;
  b.p[l0] = b.p[l2] = 1.8, b.p[l1] = b.p[l3] = 0.7;
  const std::string cause =
      "the constraints cannot be solved for the dependent speeds u2 and u3 at this state";
  for (const double turned : {0.0, 0.3}) { // in line, and not
    b.x[q1] = turned, b.x[q2] = -turned, b.x[q3] = std::numbers::pi + turned;
    expect_status<four_bars::System>(b.x, b.p, b.r, turned == 0 ? cause : "");
    auto other = kanexpr::derive<TurnedSystem>();
    auto udot = other.function(other.get(quantity::udot));
    udot(b.x, b.p, b.r);
    EXPECT_EQ(udot.status().cause(), turned == 0 ? cause : "");
  }
}

// In micrometers or light years, with masses of dust or suns, the mechanism is the same.
TEST(status, does_not_rest_on_units) {
  using namespace four_bar;
  for (const double angle : {-1.7, 1e-6, 0.0}) {
    four_bars metres;
    metres.x[q3] = angle;
    const auto expected = four_bars::eom::udot(metres.x, metres.p, metres.r);
    EXPECT_EQ(static_cast<bool>(expected.status), angle != 0);
    for (const double length : {1e-12, 1e-5, 1e7, 1e12})
      for (const double mass : {1e-12, 1e12}) {
        four_bars b = metres;
        for (double* l : {&b.p[l0], &b.p[l1], &b.p[l2], &b.p[l3], &b.p[d1], &b.p[d2], &b.p[d3], &b.p[g]})
          *l *= length;
        for (double* m : {&b.p[m1], &b.p[m2], &b.p[m3]}) *m *= mass;
        for (double* i : {&b.p[I1], &b.p[I2], &b.p[I3]}) *i *= mass * length * length;
        b.r *= mass * length * length;
        const auto udot = four_bars::eom::udot(b.x, b.p, b.r);
        EXPECT_EQ(udot.status.cause(), expected.status.cause()) << length << ' ' << mass;
        if (angle < -1) { // closer to the singularity, rounding dominates
          EXPECT_LE((udot - expected).norm(), 1e-12 * expected.norm()) << length << ' ' << mass;
        }
      }
  }
}

TEST(status, names_rates_that_cannot_be_solved_for) {
  using System = rolling_disc_constrained::System;
  using eom = kanexpr::equations_of_motion<System>;
  eom::state x = eom::state::Constant(0.4);
  const eom::parameters p = eom::parameters::Constant(1.1);
  expect_status<System>(x, p, eom::inputs::Zero(), "");
  x[rolling_disc_constrained::q2] = std::numbers::pi / 2; // the disc lies flat
  expect_status<System>(
      x, p, eom::inputs::Zero(),
      "the kinematic differential equations cannot be solved for the rate of coordinate q1 at this state");
}

TEST(status, knows_any_number_of_causes) {
  using eom = kanexpr::equations_of_motion<beads::System>;
  eom::state x = eom::state::Constant(0.4);
  expect_status<beads::System>(x, eom::parameters(), eom::inputs(), "");
  for (const int which : {beads::count - 1, 33, 2}) { // the first cause is reported
    x(which) = std::numbers::pi / 2;
    expect_status<beads::System>(
        x, eom::parameters(), eom::inputs(),
        "the kinematic differential equations cannot be solved for the rate of coordinate q" +
            std::to_string(which) + " at this state");
  }
}

TEST(status, names_the_speed_at_which_the_mass_matrix_fails) {
  using System = gimbal::System;
  using eom = kanexpr::equations_of_motion<System>;
  eom::state x = eom::state::Constant(0.4);
  expect_status<System>(x, eom::parameters(), eom::inputs(), "");
  x[gimbal::q2] = 1e-4; // nearly
  expect_status<System>(x, eom::parameters(), eom::inputs(), "");
  x[gimbal::q2] = 0; // the first and the last axis coincide
  expect_status<System>(x, eom::parameters(), eom::inputs(),
                        "the mass matrix is singular at this state: its elimination fails at the speed u1");
}

TEST(status, names_the_speed_that_a_mass_of_zero_leaves_alone) {
  four_bars b;
  using namespace four_bar;
  const std::string cause =
      "the mass matrix is singular at this state: its elimination fails at the speed u1";
  for (const double mass : {0.0, 1e-200}) {
    for (double* m : {&b.p[m1], &b.p[m2], &b.p[m3], &b.p[I1], &b.p[I2], &b.p[I3]}) *m = mass;
    expect_status<System>(b.x, b.p, b.r, mass > 0 ? "" : cause);
  }
}

// NaN and infinite values are not reported as singular.
TEST(status, does_not_call_singular_what_is_not_finite) {
  using namespace four_bar;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const double wrong : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
    const auto expect_not_finite = [&](auto change) {
      four_bars b;
      change(b);
      expect_status<System>(b.x, b.p, b.r,
                            "the results are not finite at this state; check for unset values");
    };
    expect_not_finite([&](four_bars& b) { b.p[m1] = wrong; });
    expect_not_finite([&](four_bars& b) { b.p[g] = wrong; });
    expect_not_finite([&](four_bars& b) { b.p[l2] = wrong; });
    expect_not_finite([&](four_bars& b) { b.r[T] = wrong; });
    expect_not_finite([&](four_bars& b) { b.x[q1] = wrong; });
    expect_not_finite([&](four_bars& b) { b.x[q3] = wrong; });
    expect_not_finite([&](four_bars& b) { b.x[u1] = wrong; });
  }
}

TEST(status, is_left_out_where_no_mass_can_be_missing) {
  using eom = kanexpr::equations_of_motion<two_rods::System>;
  static_assert(std::is_same_v<decltype(eom::udot(eom::state())), Eigen::Vector2d>);
  auto derived = kanexpr::derive<two_rods::System>();
  const auto udot = derived.get(quantity::udot);
  EXPECT_EQ(derived.equations().singularity_checks_of(kanexpr::symbolic::nodes_of(udot.entries)).size(), 0);
}

// Like those of compiled linearizations, whatever the cause.
TEST(status, reports_linearizations_that_are_not_finite) {
  auto derived = kanexpr::derive<two_rods::System>();
  auto linear = derived.linearize();
  const auto measured = derived.measured_by<two_rods::u1 * sin(two_rods::q2)>();
  auto udot = derived.function(derived.udot());
  for (const auto& wanted : {derived.get(quantity::state_matrix), derived.get(quantity::state_jacobian),
                             derived.get(quantity::implicit_mass_matrix), linear.explicit_form().A,
                             linear.implicit_form().A, linear.outputs(measured).C}) {
    auto f = derived.function(wanted);
    Eigen::Vector4d x(0.1, 0.2, 0.3, 0.4);
    f(x), udot(x);
    EXPECT_TRUE(f.status());
    x(1) = std::numeric_limits<double>::quiet_NaN();
    f(x), udot(x);
    EXPECT_EQ(f.status().cause(), "the results are not finite at this state; check for unset values");
    EXPECT_TRUE(udot.status());
  }
}

TEST(status, is_not_asked_for_what_needs_no_solution) {
  four_bars b;
  b.x[four_bar::q3] = 0;
  const double energy = four_bars::eom::kinetic_energy(b.x, b.p, b.r); // has no status
  EXPECT_GT(energy, 0);
  auto derived = kanexpr::derive<four_bars::System>();
  auto interpreted = derived.function(derived.get(quantity::kinetic_energy));
  interpreted(b.x, b.p, b.r);
  EXPECT_TRUE(interpreted.status());
}

// A quotient of the model, a logarithm, and a spring of zero length.
TEST(status, tells_what_is_not_finite) {
  using namespace pushed_bead;
  using eom = kanexpr::equations_of_motion<System>;
  const std::string cause = "the results are not finite at this state; check for unset values, and check the "
                            "quotients and functions of x and y";
  eom::parameters p;
  p[m] = 2, p[k] = 3, p[l] = 1;
  const auto expect_at = [&](double to_x, double to_y, const std::string& wanted) {
    eom::state at;
    at << to_x, to_y, 0.3, -0.4;
    expect_status<System>(at, p, eom::inputs(), wanted);
    const Eigen::Vector4f x_float = at.cast<float>();
    const Eigen::Vector3f p_float = p.cast<float>();
    EXPECT_EQ(eom::rhs(x_float, p_float).status.cause(), wanted);
  };
  expect_at(2, 1, "");
  expect_at(0, 1, cause);  // log(0)
  expect_at(-1, 1, cause); // log(-1)
  expect_at(3, 0, cause);  // 0/0 for the direction of the spring
  p[m] = 1e-40;            // 1/m overflows float
  eom::state at;
  at << 2, 1, 0.3, -0.4;
  EXPECT_TRUE(eom::rhs(at, p).status);
  EXPECT_EQ(eom::rhs(at.cast<float>().eval(), p.cast<float>().eval()).status.cause(), cause);
}

TEST(status, tells_of_numbers_without_a_finite_reciprocal) {
  using light_pendulum::System;
  using eom = kanexpr::equations_of_motion<System>;
  eom::state x;
  x << 0.3, 0.2;
  eom::inputs r;
  r << 1;
  expect_status<System>(x, eom::parameters(), r,
                        "the results are not finite at this state; check for unset values, and for numbers "
                        "of the system that are too small or too large");
}

TEST(status, is_written_as_its_cause) {
  std::ostringstream text;
  text << kanexpr::status() << '/' << kanexpr::status("nothing is solved");
  EXPECT_EQ(text.str(), "/nothing is solved");
}

TEST(status, of_finiteness_comes_with_what_may_not_be) {
  using namespace pushed_bead;
  using eom = kanexpr::equations_of_motion<System>;
  eom::state at;
  at << 2, 0, 0.3, -0.4;
  const eom::parameters p{1, 2, 3};
  const auto quotient = kanexpr::function<System, k / x + l>{}(at, p);
  EXPECT_TRUE(quotient.status);
  EXPECT_EQ(quotient, 4);
  EXPECT_EQ((kanexpr::function<System, k / y>{}(at, p).status.cause()),
            "the results are not finite at this state; check for unset values, and check the quotients and "
            "functions of y");
  // the root of a sum of squares is always a number
  static_assert(std::is_same_v<decltype(eom::potential_energy(at, p)), double>);
}

// If lengths are unbounded, a nonzero value may be lost by rounding.
TEST(status, tells_of_pivots_that_rounding_takes) {
  using namespace turntable;
  using eom = kanexpr::equations_of_motion<System>;
  for (const double length : {1.0, 3e8}) {
    eom::state at;
    at << 0.1, length, -length, 0.2, 0.3, 0.4;
    expect_status<System>(
        at, eom::parameters(), eom::inputs(),
        length > 1 ? "the mass matrix is singular at this state: its elimination fails at the speed w" : "");
  }
}

} // namespace
