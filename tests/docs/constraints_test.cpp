// builds: clang++
// Constraints: docs/guide/constraints.md.
#include "docs/complete.hpp"
#include "docs/printed.hpp"
#include "models/appell_hamel.hpp"
#include "models/four_bar.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <iostream>

namespace {

using namespace kanexpr;

namespace lists {

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"L"> L;
constexpr parameter<"v0"> v0;
constexpr parameter<"k"> k;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, q1 * N::x + q2 * N::y> {};
struct P3 : offset<P3, P, L * N::x> {};
struct Bearing : offset<Bearing, O, L * N::y> {};
struct Contact : offset<Contact, P, -L * N::y> {};

static_assert(docs::complete<
#include <docs/guide/constraints/configuration.cpp>
              >);
static_assert(docs::complete<
#include <docs/guide/constraints/velocity.cpp>
              >);

struct Bob : particle<Bob, P, 1> {};

template <class... Words>
struct system : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>,
                            kinematics<dot(q1) == u1, dot(q2) == u2>, bodies<Bob>, Words...> {};

using decaying = system<
#include <docs/guide/constraints/decaying.cpp>
    >;
using level = system<
#include <docs/guide/constraints/level.cpp>
    >;

#include <docs/guide/constraints/stabilized.cpp>

using stabilized = system<
#include <docs/guide/constraints/stabilized_words.cpp>
    >;

TEST(constraints, have_accelerations) {
  EXPECT_EQ(derive<decaying>().mistake(), "");
  EXPECT_EQ(derive<level>().mistake(), "");
  EXPECT_EQ(derive<stabilized>().mistake(), "");
}

} // namespace lists

namespace linkage {

using namespace four_bar;

struct System
    : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                  kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3>,
                  configuration_constraints<zero_along<position_of<P3, Bearing>, N::x, N::y>>, inputs<T>,
                  bodies<Crank, Coupler, Rocker>, loads<gravity<-g * N::y>, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

TEST(constraints, have_dependent_speeds) {
#include <docs/guide/constraints/chosen.cpp>
  EXPECT_EQ(model.names_of_dependent_coordinates(), "q1 and q3");
  EXPECT_EQ(model.names_of_dependent_speeds(), "u1 and u3");
}

TEST(constraints, are_assembled) {
  eom::state x{{q1, -2.27}, {q2, 3}, {q3, -1.5}, {u2, 0.6}};
  const eom::parameters p{{l0, 2}, {l1, 1}, {l2, 2},   {l3, 1.5}, {d1, 0.5}, {d2, 1},   {d3, 0.75},
                          {m1, 1}, {m2, 2}, {m3, 1.5}, {I1, 0.1}, {I2, 0.7}, {I3, 0.3}, {g, 9.81}};
  const eom::inputs r{{T, 0}};
#include <docs/guide/constraints/assembled.cpp>
  EXPECT_TRUE(built) << built.cause();
  const docs::printed here;
#include <docs/guide/constraints/least.cpp>
  EXPECT_TRUE(found) << found.cause();
  EXPECT_LT((found.multipliers - eom::multipliers(x, p, r)).norm(), 1e-12 * found.multipliers.norm());
}

} // namespace linkage

namespace nonlinear {

using namespace appell_hamel;

constexpr parameter<"c"> c;
constexpr parameter<"d"> d;
constexpr parameter<"power"> power;

template <class Words>
struct with : kane_system<inertial<N>, coordinates<x, y, z>, speeds<u, v, w>,
                          kinematics<dot(x) == u, dot(y) == v, dot(z) == w>, bodies<Weight>, Words> {};
using on_cone = with<
#include <docs/guide/constraints/nonlinear.cpp>
    >;
using at_speed = with<
#include <docs/guide/constraints/nonlinear_speed.cpp>
    >;
using at_power = with<
#include <docs/guide/constraints/nonlinear_power.cpp>
    >;

TEST(constraints, need_not_be_linear) {
  for (auto model : {derive<on_cone>(), derive<at_speed>(), derive<at_power>()}) {
    EXPECT_EQ(model.udot().rows, 3);
    EXPECT_EQ(model.mistake(), "");
  }
}

TEST(constraints, have_speeds_near_the_guess) {
  const parameter_values<System> p{{m, 1}, {a, 0.7}, {g, 9.81}};
  const input_values<System> r{{F, 0}};
#include <docs/guide/constraints/nonlinear_assembled.cpp>
  EXPECT_TRUE(solved) << solved.cause();
  EXPECT_NEAR(x[w], 1 / 0.7, 1e-15);
  x[w] = 0;
  EXPECT_EQ(assemble<System>(x, p, r).cause(),
            "the search for the dependent speeds ended at a singularity of the velocity constraints, with a "
            "residual of 1");
}

} // namespace nonlinear

namespace pivot {

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr speed<"ux"> ux;
constexpr speed<"uy"> uy;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr parameter<"g"> g;
struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};

#include <docs/guide/constraints/pivot.cpp>

using eom = equations_of_motion<System>;

TEST(constraints, have_auxiliary_speeds) {
#include <docs/guide/constraints/pivot_forces.cpp>
  EXPECT_NEAR(force(0), -21.7279, 5e-5);
  EXPECT_NEAR(force(1), -6.7212, 5e-5);
  EXPECT_NEAR(force.norm(), 22.744, 5e-4);
  EXPECT_EQ(eom::auxiliary_forces(x, p), force);
  EXPECT_EQ((function<System, mechanics::quantity::auxiliary_forces>{}(x, p)), force);
}

} // namespace pivot
} // namespace
