// builds: clang++ all
// Cables along pathways: their places are those of the shortest lines.
#include "animate/samples.hpp"

#include <kanexpr/animate.hpp>
#include <kanexpr/animate/picture_of.hpp>
#include <kanexpr/kanexpr.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace {

using namespace kanexpr;
using Eigen::Vector3d;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"r"> r;
constexpr input<"T"> T;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct C : offset<C, O, 0.5 * N::z> {};
struct Rim : offset<Rim, C, r * A::x> {};
struct Eye : offset<Eye, O, 2.0 * N::x + 1.0 * N::y> {};
struct Far : offset<Far, O, 2.0 * N::x + 0.2 * N::y + 0.5 * N::z> {};
struct Bob : particle<Bob, Rim, 1.0> {};

using String = around_cylinder<A, C, 2.0 * A::z, r, on_surface<Rim>, Far, wrapping::counterclockwise>;
using Rope = through<Rim, Eye, Far>;
using Net = around_sphere<C, r, Far, Eye>;
using Coil = around_cone<N, O, N::z, 0.2, Far, Eye, wrapping::clockwise>;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<simple>, bodies<Bob>,
                            loads<force_along<String, T>>> {};

using shown = picture<System, up<N::z>, show<cable<0.01, String>, named<"string">>, show<cable<0.01, Rope>>,
                      show<cable<r / 9, Net>>, show<cable<0.02, straight<C, Far>>>>;

tests::samples<System> turning() {
  tests::samples<System> run;
  run.p[r] = 0.3;
  for (const double angle : {-2.0, -1.5, 0.3}) run.all.push_back({angle, {{q, angle}, {u, 0}}, {{T, 1}}});
  return run;
}

TEST(cable, follows_the_pathways_of_the_model) {
  const animation a = animated<shown>(turning());
  ASSERT_TRUE(a) << a.cause();
  const animation::shape* string = a.find("string");
  ASSERT_NE(string, nullptr);
  EXPECT_EQ(string->kind, "cable");
  ASSERT_EQ(string->places, 14u);
  EXPECT_EQ(string->straight_parts, std::vector<std::size_t>{12});
  const Vector3d center(0, 0, 0.5), far(2, 0.2, 0.5);
  // The tangent from Far leaves the drum at this angle, on the side of y < 0.
  const double leaves = std::atan2(0.2, 2) - std::acos(0.3 / std::hypot(2, 0.2));
  for (std::size_t k = 0; k < 2; ++k) {
    const double starts = a.times[k];
    for (std::size_t i = 0; i <= 12; ++i) {
      const double angle = starts + static_cast<double>(i) / 12 * (leaves - starts);
      const Vector3d place = center + 0.3 * Vector3d(std::cos(angle), std::sin(angle), 0);
      EXPECT_LT((string->placement_at(k, i).position - place).norm(), 1e-14);
    }
    EXPECT_LT((string->placement_at(k, 13).position - far).norm(), 1e-15);
  }
  // It is straight when the rim has turned past the tangent.
  const Vector3d rim = center + 0.3 * Vector3d(std::cos(0.3), std::sin(0.3), 0);
  for (std::size_t i = 0; i < 14; ++i)
    EXPECT_LT((string->placement_at(2, i).position - rim).cross(far - rim).norm(), 1e-14);

  const animation::shape* rope = a.find("cable from Rim to Far");
  ASSERT_NE(rope, nullptr);
  ASSERT_EQ(rope->places, 3u);
  EXPECT_EQ(rope->straight_parts, (std::vector<std::size_t>{0, 1}));
  EXPECT_LT((rope->placement_at(2, 0).position - rim).norm(), 1e-15);
  EXPECT_LT((rope->placement_at(2, 1).position - Vector3d(2, 1, 0)).norm(), 1e-15);
  const animation::shape* net = a.find("cable from Far to Eye");
  ASSERT_NE(net, nullptr);
  EXPECT_EQ(net->places, 15u);
  EXPECT_EQ(net->sizes, std::vector<double>{0.3 / 9});
  EXPECT_LT((net->placement_at(0, 14).position - Vector3d(2, 1, 0)).norm(), 1e-15);
  EXPECT_NE(a.find("cable from C to Far"), nullptr);
}

TEST(cable, reports_a_line_that_does_not_exist) {
  tests::samples<System> run = turning();
  run.p[r] = 3; // Far is inside the drum
  EXPECT_EQ(animated<shown>(run).cause(), "the position of the string is not finite at t = -2");
}

TEST(cable, is_part_of_the_default_picture) {
  const animation a = animated(derive<System>(), turning());
  ASSERT_TRUE(a) << a.cause();
  const animation::shape* string = a.find("cable from Rim to Far");
  ASSERT_NE(string, nullptr);
  EXPECT_EQ(string->places, 14u);
  EXPECT_NEAR((string->placement_at(1, 4).position - Vector3d(0, 0, 0.5)).norm(), 0.3, 1e-14);
  const animation::shape* drum = a.find("cylinder of the cable from Rim to Far");
  ASSERT_NE(drum, nullptr);
  EXPECT_NEAR(std::abs(drum->placement_at(2).orientation(2, 2)), 1, 1e-15);
}

using Winding = around_cone<N, O, N::z, 0.2, Rim, Far, wrapping::counterclockwise>;
struct Wound : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<simple>, bodies<Bob>,
                           loads<force_along<Winding, T>>> {};

TEST(cable, shows_its_cone_in_the_default_picture) {
  tests::samples<Wound> run;
  run.p[r] = 0.3;
  for (const double angle : {-2.0, -1.5, 0.3}) run.all.push_back({angle, {{q, angle}, {u, 0}}, {{T, 1}}});
  const animation a = animated(derive<Wound>(), run);
  ASSERT_TRUE(a) << a.cause();
  const animation::shape *cable = a.find("cable from Rim to Far"),
                         *cone = a.find("cone of the cable from Rim to Far");
  ASSERT_NE(cable, nullptr);
  ASSERT_NE(cone, nullptr);
  EXPECT_EQ(cone->kind, "cone");
  EXPECT_NEAR(cone->sizes[0], cone->sizes[1] * std::tan(0.97 * 0.2), 1e-15);
  EXPECT_LT(cone->placement_at(1).position.norm(), 1e-15); // the tip
  EXPECT_NEAR(cone->placement_at(1).orientation(2, 2), 1, 1e-15);
  double deepest = 0;
  for (const animate::placement& each : cable->placements) deepest = std::max(deepest, each.position.z());
  EXPECT_NEAR(cone->sizes[1], 1.1 * deepest, 1e-14);
  EXPECT_GT(deepest, 0.499);
}

} // namespace
