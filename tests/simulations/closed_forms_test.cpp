// builds: clang++
// Motions that are known in closed form.
#include <kanexpr/simulate.hpp>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <models/pivot_body.hpp>
#include <models/rolling_disc.hpp>
#include <models/simple_pendulum.hpp>
#include <models/spinning_top.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace kanexpr;

// Landau & Lifshitz, Mechanics, §11: 4 √(l/g) K(sin(q₀/2)).
TEST(closed_form, period_of_a_pendulum) {
  using namespace simple_pendulum;
  for (const double amplitude : {0.1, 1.0, 2.0, 3.0}) {
    const double length = 0.7, gravity_strength = 9.81;
    const double period =
        4 * std::sqrt(length / gravity_strength) * boost::math::ellint_1(std::sin(amplitude / 2));
    const auto run = simulate<System>({{q, amplitude}, {u, 0}},
                                      {{m, 1.3}, {l, length}, {g, gravity_strength}, {c, 0}}, {0, period},
                                      {.inputs = {{T, 0}},
                                       .relative_tolerance = 1e-12,
                                       .absolute_tolerance = 1e-14,
                                       .events = {when<System, simple_pendulum::q>("bottom")}});
    ASSERT_TRUE(run) << run.cause();
    ASSERT_EQ(run.events.size(), 2u);
    EXPECT_NEAR(run.events[0].t, period / 4, 1e-9 * period);
    EXPECT_NEAR(run.events[1].t, period * 3 / 4, 1e-9 * period);
    EXPECT_NEAR(run.state[q], amplitude, 1e-9);
    EXPECT_NEAR(run.state[u], 0, 1e-8);
  }
}

// The error of a run is the sum of the errors of its steps, so it is a fixed multiple of the tolerance.
TEST(closed_form, errors_of_adams_are_proportional_to_the_tolerance) {
  using namespace simple_pendulum;
  const double amplitude = 2.5, ten_periods = 40 * boost::math::ellint_1(std::sin(amplitude / 2));
  for (double tolerance = 1e-5; tolerance > 5e-14; tolerance /= 10) {
    const auto run = simulate<System>(
        {{q, amplitude}, {u, 0}}, {{m, 1.3}, {l, 1}, {g, 1}, {c, 0}}, {0, ten_periods},
        {.inputs = {{T, 0}}, .relative_tolerance = tolerance, .absolute_tolerance = tolerance});
    ASSERT_TRUE(run) << run.cause();
    EXPECT_LT(std::hypot(run.state[q] - amplitude, run.state[u]), 10000 * tolerance) << tolerance;
  }
}

// Steady precession: A ψ̇² cos θ − C ω₃ ψ̇ + m g l = 0 (Goldstein, Classical Mechanics, 5.7).
TEST(closed_form, precession_of_a_spinning_top) {
  using namespace spinning_top;
  const double mass = 0.4, length = 0.08, strength = 9.81, about = 6e-4, tilt = 0.6, spin = 260;
  const double of_centre = 6e-4, across = of_centre + mass * length * length; // about the tip
  const double root =
      std::sqrt(about * about * spin * spin - 4 * across * std::cos(tilt) * mass * strength * length);
  const double precession = (about * spin - root) / (2 * across * std::cos(tilt));
  const auto run =
      simulate<System>({{q1, 0}, {q2, tilt}, {q3, 0}, {u1, 0}, {u2, precession * std::sin(tilt)}, {u3, spin}},
                       {{m, mass}, {l, length}, {g, strength}, {A, of_centre}, {C, about}}, {0, 10},
                       {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-13, .output_every = 0.1});
  ASSERT_TRUE(run) << run.cause();
  ASSERT_EQ(run.trajectory.size(), 101u);
  for (const auto& s : run.trajectory) {
    EXPECT_NEAR(s.x[q1], precession * s.t, 1e-8);
    EXPECT_NEAR(s.x[q2], tilt, 1e-9);
    EXPECT_NEAR(s.x[u3], spin, 1e-9 * spin);
  }
}

// Euler's top about all three axes, ω = (a cn τ, b sn τ, c dn τ) (Landau & Lifshitz, Mechanics, §37).
TEST(closed_form, body_without_torque) {
  using namespace pivot_body;
  const double i1 = 1, i2 = 2, i3 = 2.8, w1 = 0.7, w3 = 1.1; // at the start ω₂ = 0
  const double energy = i1 * w1 * w1 + i3 * w3 * w3, momentum = i1 * i1 * w1 * w1 + i3 * i3 * w3 * w3;
  ASSERT_GT(momentum, energy * i2);
  const double b = std::sqrt((energy * i3 - momentum) / (i2 * (i3 - i2)));
  const double rate = std::sqrt((i3 - i2) * (momentum - energy * i1) / (i1 * i2 * i3));
  const double modulus =
      std::sqrt((i2 - i1) * (energy * i3 - momentum) / ((i3 - i2) * (momentum - energy * i1)));
  const auto run = simulate<System>(
      {{e0, 1}, {e1, 0}, {e2, 0}, {e3, 0}, {u1, w1}, {u2, 0}, {u3, w3}},
      {{m, 1}, {Ixx, i1}, {Iyy, i2}, {Izz, i3}, {Ixy, 0}, {g, 0}, {a, 0}, {pivot_body::b, 0}, {c, 0}},
      {0, 60},
      {.inputs = {{T1, 0}, {T2, 0}, {T3, 0}},
       .relative_tolerance = 1e-11,
       .absolute_tolerance = 1e-13,
       .output_every = 0.25});
  ASSERT_TRUE(run) << run.cause();
  for (const auto& s : run.trajectory) {
    double cn = 0, dn = 0;
    const double sn = boost::math::jacobi_elliptic(modulus, rate * s.t, &cn, &dn);
    EXPECT_NEAR(s.x[u1], w1 * cn, 1e-8);
    EXPECT_NEAR(s.x[u2], b * sn, 1e-8);
    EXPECT_NEAR(s.x[u3], w3 * dn, 1e-8);
  }
  const auto momenta = run.trajectory.along(equations_of_motion<System>::angular_momentum);
  for (const auto& each : momenta) EXPECT_LT((each - momenta[0]).norm(), 1e-8 * momenta[0].norm());
}

// A fast top whose axis is at rest when it is released. With y = cos θ₀ − cos θ of the greatest lean,
// y² + (p − 2 cos θ₀) y − sin² θ₀ = 0 (Goldstein, Classical Mechanics, 5.7).
TEST(closed_form, nutation_of_a_spinning_top) {
  using namespace spinning_top;
  const double mass = 0.4, length = 0.08, strength = 9.81, about = 6e-4, across = 6e-4;
  const double tilt = 0.5, spin = 180;
  std::vector<double> most;
  const auto keep = [&](moment<System>& now) { most.push_back(now.x[q2]); };
  const auto run = simulate<System>({{q1, 0}, {q2, tilt}, {q3, 0}, {u1, 0}, {u2, 0}, {u3, spin}},
                                    {{m, mass}, {l, length}, {g, strength}, {A, across}, {C, about}}, {0, 3},
                                    {.relative_tolerance = 1e-12,
                                     .absolute_tolerance = 1e-13,
                                     .events = {when<System, u1>("leans most", crossing::falling, keep)}});
  ASSERT_TRUE(run) << run.cause();
  ASSERT_GE(most.size(), 10u);
  const double about_tip = across + mass * length * length;
  const double p = std::pow(about * spin, 2) / (2 * about_tip * mass * strength * length);
  const double b = p / 2 - std::cos(tilt);
  const double greatest = std::acos(std::cos(tilt) + b - std::hypot(b, std::sin(tilt)));
  for (const double lean : most) EXPECT_NEAR(lean, greatest, 1e-9 * greatest);
}

TEST(closed_form, disc_is_back_after_a_turn_in_its_circle) {
  using namespace rolling_disc;
  const double radius = 0.3, strength = 9.81, lean = 0.35, turning = 1.9,
               about_lean = turning * std::cos(lean);
  // The moments about the contact point, along the ground and across the path of the disc, balance.
  const double spin = (about_lean * about_lean * std::tan(lean) / 4 - strength / radius * std::sin(lean)) /
                      (1.5 * about_lean);
  const auto run = simulate<System>({{q1, 0}, {q2, lean}, {q3, 0}, {u1, 0}, {u2, spin}, {u3, about_lean}},
                                    {{r, radius}, {m, 2}, {g, strength}}, {0, 2 * std::numbers::pi / turning},
                                    {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-13});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_NEAR(run.state[q1], 2 * std::numbers::pi, 1e-8);
  EXPECT_NEAR(run.state[q2], lean, 1e-8);
  EXPECT_NEAR(run.state[u2], spin, 1e-8 * std::abs(spin));
}

} // namespace
