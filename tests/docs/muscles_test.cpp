// builds: clang++ all
// Muscles: docs/guide/muscles.md.
#include "docs/no_mistake.hpp"

#include <kanexpr/blocks.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/operating_point.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <docs/guide/muscles/elbow.cpp>

namespace {

TEST(muscles, have_states) {
  using namespace elbow;
  using eom = equations_of_motion<System>;
#include <docs/guide/muscles/rest.cpp>
  EXPECT_EQ(x(2), 0.2);
  EXPECT_EQ(x(3), rest.tendon_force);
  const eom::parameters p{{m, 1.5}, {J, 0.01}};
  const auto rates = eom::rhs(x, p, eom::inputs{{e, 0.2}});
  EXPECT_NEAR(rates(2), 0, 1e-15);
  EXPECT_NEAR(rates(3), 0, 1e-11);
#include <docs/guide/muscles/held.cpp>
  ASSERT_TRUE(held) << held.cause();
  EXPECT_NEAR(held.r[e], 0.0798, 5e-5);
  EXPECT_EQ(held.x[Biceps::activation], held.r[e]);
  const double arm = 0.04 * 0.3 / std::hypot(0.3, 0.04), weight = 0.15 * 1.5 * 9.81;
  EXPECT_NEAR(rates(1), (600 * rest.tendon_force * arm - weight) / (0.01 + 1.5 * 0.15 * 0.15), 1e-12);
}

TEST(muscles, have_formulations) {
  using kanexpr::muscle_formulation;
  for (const muscle_formulation each : {
#include <docs/guide/muscles/formulations.cpp>
       })
    EXPECT_LE(each, muscle_formulation::fiber_length);
}

TEST(muscles, are_built) {
  using namespace kanexpr;
  runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u");
  b.kinematic_equation(b.dot(q) - u);
  const auto shoulder = b.origin("Shoulder"),
             insertion = b.offset("Insertion", shoulder, b.along(b.inertial_frame(), q, 0, 0));
  b.particle("Bone", insertion, b.number(1));
#include <docs/guide/muscles/built.cpp>
  EXPECT_EQ((b.check)().view(), "");
  EXPECT_EQ(b.mechanism().speeds.find(activation), 1);
  EXPECT_EQ(b.mechanism().speeds.find(length), 2);
}

} // namespace
