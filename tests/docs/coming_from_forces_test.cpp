// builds: clang++ all
// The forces of other programs in the words of kanexpr: docs/coming-from/forces.md.
#include "docs/no_mistake.hpp"

#include <kanexpr/blocks.hpp>
#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using namespace kanexpr;

namespace hinge {

constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr parameter<"I"> I;
constexpr parameter<"k"> k;
constexpr parameter<"q0"> q0;
constexpr parameter<"kc"> kc;
constexpr parameter<"qc"> qc;
constexpr parameter<"kdf"> kdf;
constexpr parameter<"ksf"> ksf;
constexpr parameter<"kv"> kv;
constexpr parameter<"w"> w;
struct N : inertial_ground<N> {};
#include <docs/coming-from/forces/door.cpp>

} // namespace hinge

// Drake's formula: a step s(t, x) = tanh(x/t), and doublet(t, x) = 2 s (1 - s^2).
TEST(forces_of_other_programs, hinge_of_a_door) {
  using namespace hinge;
  docs::expect_no_mistake<System>();
  using eom = equations_of_motion<System>;
  const eom::parameters p{{m, 4},    {l, 0.8},   {I, 0.3},   {k, 2},     {q0, 0.4}, {kc, 1.5},
                          {qc, 0.1}, {kdf, 0.3}, {ksf, 0.2}, {kv, 0.05}, {w, 0.01}};
  const auto step = [](double t, double x) { return std::tanh(x / t); };
  const auto doublet = [&](double t, double x) { return 2 * step(t, x) * (1 - std::pow(step(t, x), 2)); };
  for (const auto& [q, u] : {std::pair(0.03, 0.004), std::pair(0.07, -0.02), std::pair(0.9, 1.0)}) {
    const double torque = -2 * (q - 0.4) + 1.5 * doublet(0.05, q - 0.05) - 0.3 * step(0.01, u) -
                          0.2 * doublet(0.01, u) - 0.05 * u;
    const double inertia = 0.3 + 4 * 0.4 * 0.4;
    EXPECT_NEAR(eom::udot(eom::state{{q_of<Door>, q}, {u_of<Door>, u}}, p)(0), torque / inertia, 1e-12);
  }
}

namespace actuator {

constexpr parameter<"tau"> tau;
constexpr parameter<"g0"> g0;
constexpr parameter<"g1"> g1;
constexpr parameter<"g2"> g2;
constexpr parameter<"b0"> b0;
constexpr parameter<"b1"> b1;
constexpr parameter<"b2"> b2;
constexpr parameter<"Fmax"> Fmax;
constexpr input<"ctrl"> ctrl;
struct N : inertial_ground<N> {};
struct Arm : pin<Arm, N, axis<N::z>, body<2, 0.5 * own::x>> {};
#include <docs/coming-from/forces/affine.cpp>

} // namespace actuator

TEST(forces_of_other_programs, actuator_with_affine_gain_and_bias) {
  using namespace actuator;
  docs::expect_no_mistake<Actuated>();
  using eom = equations_of_motion<Actuated>;
  const eom::parameters p{{tau, 0.2}, {g0, 3},  {g1, 0.5},  {g2, -0.1},
                          {b0, 0.2},  {b1, -4}, {b2, -0.3}, {Fmax, 5}};
  const double q = 0.3, u = -0.8, act = 0.6;
  const auto rate = eom::rhs(eom::state{{q_of<Arm>, q}, {u_of<Arm>, u}, {Activation::output, act}}, p,
                             eom::inputs{{ctrl, 1}});
  const double torque = (3 + 0.5 * q - 0.1 * u) * act + 0.2 - 4 * q - 0.3 * u;
  EXPECT_NEAR(rate(1), 5 * std::tanh(torque / 5) / (2 * 0.25), 1e-12);
  EXPECT_NEAR(rate(2), (1 - act) / 0.2, 1e-12);
}

namespace cable {

constexpr coordinate<"x"> x;
constexpr speed<"v"> v;
constexpr parameter<"k"> k;
constexpr parameter<"l0"> l0;
constexpr parameter<"c"> c;
constexpr parameter<"F_dry"> F_dry;
constexpr parameter<"F_yield"> F_yield;
constexpr input<"F"> F;
struct N : inertial_ground<N> {};
struct P : offset<P, N, x * N::x> {};
struct Q : offset<Q, N, 1.0 * N::y> {};
struct R : offset<R, N, -0.5 * N::y> {};
struct Mass : particle<Mass, P, 2> {};
struct System : kane_system<inertial<N>, coordinates<x>, speeds<v>, kinematics<simple>, bodies<Mass>,
                            loads<
#include <docs/coming-from/forces/lines.cpp>
                                >> {
};

} // namespace cable

TEST(forces_of_other_programs, loads_on_one_line) { docs::expect_no_mistake<cable::System>(); }

namespace capstan {

using namespace cable;
constexpr parameter<"mu"> mu;
constexpr parameter<"vs"> vs;
#include <docs/coming-from/forces/capstan.cpp>

} // namespace capstan

// Toward the drum at (0, 1), the tension is smaller by exp(-mu pi/2), away from it larger.
TEST(forces_of_other_programs, cable_on_a_rough_drum) {
  using namespace capstan;
  docs::expect_no_mistake<Pulled>();
  using eom = equations_of_motion<Pulled>;
  const eom::parameters p{{mu, 0.3}, {vs, 1e-3}};
  for (const double speed : {-1.0, 1.0}) {
    const double tension = 10 * std::exp(0.3 * std::numbers::pi / 2 * speed); // x > 0, so v > 0 moves away
    const auto udot = eom::udot(eom::state{{x, 1}, {v, speed}}, p, eom::inputs{{F, 10}});
    EXPECT_NEAR(udot(0), -tension / std::sqrt(2) / 2, 1e-12);
  }
}

} // namespace
