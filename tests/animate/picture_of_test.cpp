// builds: clang++ all
// Default pictures: which shapes are chosen for a model, their sizes and where they are.
#include "animate/samples.hpp"
#include "models/double_pendulum.hpp"
#include "models/rolling_disc.hpp"

#include <kanexpr/animate/picture_of.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;
using Eigen::Vector3d;
using symbolic::expression;

/// Samples of a run-time model at given coordinates, at rest.
struct positions {
  struct sample {
    double t;
    Eigen::VectorXd x, r;
  };
  std::vector<sample> all{};
  Eigen::VectorXd p{};

  positions(const model& m, const std::vector<double>& parameters, const std::vector<std::vector<double>>& q)
      : p(Eigen::VectorXd::Map(parameters.data(), static_cast<Eigen::Index>(parameters.size()))) {
    for (std::size_t k = 0; k < q.size(); ++k) {
      sample s{static_cast<double>(k), Eigen::VectorXd::Zero(m.known()->coordinates + m.known()->speeds), {}};
      for (std::size_t i = 0; i < q[k].size(); ++i) s.x(static_cast<Eigen::Index>(i)) = q[k][i];
      all.push_back(s);
    }
  }
  auto begin() const { return all.begin(); }
  auto end() const { return all.end(); }
  const auto& parameters() const { return p; }
};

std::vector<std::string> names_of(const animation& a) {
  std::vector<std::string> names;
  for (const animation::shape& s : a.shapes) names.push_back(s.kind + ": " + s.name);
  return names;
}

animation double_pendulum_at(double scale) {
  using namespace double_pendulum;
  tests::samples<System> at;
  at.p = {{m1, 1},     {m2, 1},   {d1, 0.5 * scale},        {d2, 0.5 * scale},
          {l1, scale}, {I1, 0.1}, {I2, scale * scale / 12}, {g, 9.81},
          {c1, 0},     {c2, 0}};
  at.all.push_back({0, {{q1, 0}, {q2, 0}, {u1, 0}, {u2, 0}}, {{T1, 0}, {T2, 0}}});
  at.all.push_back({1, {{q1, 0.5}, {q2, 1}, {u1, 0}, {u2, 0}}, {{T1, 0}, {T2, 0}}});
  return animated<picture_of<System>>(at);
}

TEST(picture_of, shows_links_pins_and_mass_centers) {
  const animation a = double_pendulum_at(1);
  ASSERT_TRUE(a) << a.cause();
  EXPECT_EQ(names_of(a), (std::vector<std::string>{"rod: link of Bar1", "rod: link of Bar1",
                                                   "rod: link of Bar2", "cylinder: pin at O",
                                                   "cylinder: pin at J", "sphere: mass center of Bar1",
                                                   "sphere: mass center of Bar2", "cylinder: Bar2"}));
  const animate::placement first = a.find("link of Bar2")->placements[1],
                           pin = a.find("pin at J")->placements[1];
  const double angle = 0.5;
  EXPECT_NEAR(first.position.norm(), 1, 1e-14);
  EXPECT_NEAR((first.end - first.position).norm(), 0.5, 1e-14);
  EXPECT_NEAR(std::acos(first.position.dot(a.find("link of Bar2")->placements[0].position)), angle, 1e-13);
  EXPECT_LT((pin.position - first.position).norm(), 1e-14);
  EXPECT_NEAR(std::abs(pin.orientation(2, 2)), 1, 1e-14);
  EXPECT_EQ(a.columns.size(), 6); // two coordinates, two speeds and two inputs
  EXPECT_EQ(a.times, (std::vector<double>{0, 1}));
}

TEST(picture_of, has_the_sizes_of_the_model) {
  const animation small = double_pendulum_at(1), large = double_pendulum_at(10);
  ASSERT_EQ(small.shapes.size(), large.shapes.size());
  for (std::size_t i = 0; i < small.shapes.size(); ++i)
    for (std::size_t k = 0; k < small.shapes[i].sizes.size(); ++k)
      EXPECT_NEAR(large.shapes[i].sizes[k], 10 * small.shapes[i].sizes[k], 1e-12) << small.shapes[i].name;
  EXPECT_NEAR(small.find("Bar2")->sizes[1], 1, 1e-12); // the rod with the same moment of inertia
  EXPECT_NEAR(*large.ground, 10 * *small.ground, 1e-12);
}

TEST(picture_of, makes_a_rolling_body_as_large_as_its_distance_from_the_ground) {
  using namespace rolling_disc;
  tests::samples<System> at;
  at.p = {{r, 0.45}, {m, 2}, {g, 9.81}};
  for (const double t : {0.0, 0.5}) // it rolls straight ahead, upright
    at.all.push_back({t, {{q1, 0}, {q2, 0}, {q3, 2 * t}, {u1, 0}, {u2, 2}, {u3, 0}}, {}});
  const animation a = animated<picture_of<System>>(at);
  ASSERT_TRUE(a) << a.cause();
  EXPECT_EQ(names_of(a), (std::vector<std::string>{"cylinder: pin at Dmc", "cylinder: Disc"}));
  EXPECT_NEAR(a.find("Disc")->sizes[0], 0.45, 1e-14);
  EXPECT_LT((a.find("Disc")->placements[1].position - Vector3d(0.45, 0, 0.45)).norm(), 1e-14);
  EXPECT_TRUE(a.carried);
  EXPECT_NEAR(*a.ground, 0, 1e-14);
  EXPECT_EQ(a.up, Vector3d(0, 0, 1)); // its weight is given as a force
}

TEST(picture_of, shows_sliders_springs_particles_and_balls_of_a_builder) {
  runtime::builder b("N");
  const auto N = runtime::builder::inertial_frame();
  const expression x = b.coordinate("x"), q1 = b.coordinate("q1"), q2 = b.coordinate("q2"),
                   q3 = b.coordinate("q3");
  const expression l = b.parameter("l"), k = b.parameter("k"), c = b.parameter("c");
  for (const expression& q : {x, q1, q2, q3})
    b.kinematic_equation(b.dot(q) - b.speed("v_" + symbolic::print(q)));
  const auto O = b.origin("O"), C = b.offset("C", O, b.along(N, x, 0, 0));
  const auto B = b.body_fixed("B", N, "123", q1, q2, q3);
  const auto P = b.offset("P", C, b.along(B, 0, 0, l));
  b.particle("Cart", C, b.number(1)), b.particle("Bob", P, b.number(1));
  b.spring(C, O, k), b.damper(C, O, c), b.gravity(b.along(N, 0, 0, -9.81));
  const runtime::pathway cable = b.through({O, C, P});
  b.force_along(cable, b.number(2)), b.linear_damper(cable, c);
  const model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  const animation a = animated(m, positions(m, {2, 1, 1}, {{-1, 0, 0, 0}, {3, 0.1, 0.2, 0.3}}));
  ASSERT_TRUE(a) << a.cause();
  EXPECT_EQ(names_of(a), (std::vector<std::string>{"rod: rail of C", "box: slider at C", "rod: link of B",
                                                   "sphere: ball joint at C", "sphere: Cart", "sphere: Bob",
                                                   "coil: spring from C to O", "rod: damper from C to O",
                                                   "rod: cable from O to C", "rod: cable from C to P"}));
  const animate::placement rail = a.find("rail of C")->placements[0];
  EXPECT_LT((rail.position - Vector3d(-1.3, 0, 0)).norm() * (rail.position - Vector3d(3.3, 0, 0)).norm(),
            1e-12);
  EXPECT_LT((rail.end - Vector3d(-1.3, 0, 0)).norm() * (rail.end - Vector3d(3.3, 0, 0)).norm(), 1e-12);
  EXPECT_LT((a.find("Bob")->placements[0].position - Vector3d(-1, 0, 2)).norm(), 1e-14);
  EXPECT_EQ(a.up, Vector3d(0, 0, 1));
}

TEST(picture_of, shows_a_free_body_as_the_solid_with_its_inertia) {
  runtime::builder b("N");
  const auto N = runtime::builder::inertial_frame();
  std::vector<expression> q;
  for (const char* called : {"x", "y", "z", "a"}) {
    q.push_back(b.coordinate(called));
    b.kinematic_equation(b.dot(q.back()) - b.speed(std::string("v_") + called));
  }
  const auto O = b.origin("O"), C = b.offset("C", O, b.along(N, q[0], q[1], q[2]));
  const auto B = b.rotated("B", N, q[3], b.along(N, 0, 0, 1));
  b.rigid_body("Box", C, B, b.number(12), b.inertia(B, 4 + 9, 1 + 9, 1 + 4));
  const model m = derive(b);
  const animation a = animated(m, positions(m, {}, {{1, 2, 3, std::numbers::pi / 2}}));
  ASSERT_EQ(names_of(a), (std::vector<std::string>{"box: Box"})) << a.cause();
  const animation::shape& box = a.shapes.front();
  const Eigen::Matrix3d edges = box.placements[0].orientation * Vector3d(box.sizes.data()).asDiagonal();
  EXPECT_LT((edges.cwiseAbs() * Vector3d::Ones() - Vector3d(2, 1, 3)).norm(), 1e-12); // 1, 2 and 3, turned
  EXPECT_FALSE(a.ground);
  EXPECT_EQ(a.system, "The model"); // the title of a page
}

/// A cantilever of length 2 along y that bends along z by q (y/2)², and carries a pendulum at its tip.
TEST(picture_of, shows_beams_bent) {
  runtime::builder b("N");
  const auto N = runtime::builder::inertial_frame();
  const expression q = b.coordinate("q"), angle = b.coordinate("angle");
  for (const expression& each : {q, angle})
    b.kinematic_equation(b.dot(each) - b.speed("v_" + symbolic::print(each)));
  const auto O = b.origin("O");
  runtime::beam_data data{.axis = b.along(N, 0, 1, 0), .length = 2.0, .mass_per_length = 1.0};
  const numeric::beams::shape parabola = numeric::beams::shape::polynomial({0.0, 0.0, 1.0});
  data.bending.push_back({b.along(N, 0, 0, 1), {.stiffness = 3.0, .shapes = {parabola}}});
  const auto beam = b.beam("Cantilever", O, N, {q}, data);
  const auto tip = b.section("Tip", beam, 1);
  const auto A = b.rotated("A", tip.frame, angle, b.along(N, 1, 0, 0));
  b.particle("Bob", b.offset("P", tip.point, b.along(A, 0, 0, -0.5)), b.number(1));
  const model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  const animation a = animated(m, positions(m, {}, {{0, 0}, {0.5, 0}}));
  ASSERT_TRUE(a) << a.cause();
  EXPECT_EQ(names_of(a), (std::vector<std::string>{"rod: link of A", "cylinder: pin at Tip", "sphere: Bob",
                                                   "beam: Cantilever"}));
  const animation::shape& shown = *a.find("Cantilever");
  EXPECT_LT((Eigen::Vector2d(shown.sizes.data()) - Eigen::Vector2d(0.16, 0.16 / 3)).norm(), 1e-12);
  ASSERT_EQ(shown.places, 9u);
  for (std::size_t i = 0; i < 9; ++i) {
    const double xi = static_cast<double>(i) / 8, slope = 2 * xi * 0.5 / 2;
    const Vector3d place(0, 2 * xi - 2 * 0.25 * xi * xi * xi / 3 / 2, 0.5 * xi * xi);
    const Vector3d tangent(0, std::cos(slope), std::sin(slope));
    EXPECT_LT((shown.placement_at(1, i).position - place).norm(), 1e-14);
    EXPECT_LT((shown.placement_at(1, i).orientation.col(2) - tangent).norm(), 1e-14);
    EXPECT_LT((shown.placement_at(1, i).orientation.col(0) - Vector3d(-1, 0, 0)).norm(), 1e-14);
  }
  const Vector3d end = shown.placement_at(1, 8).position;
  EXPECT_LT((a.find("link of A")->placements[1].position - end).norm(), 1e-14);
  ASSERT_EQ(shown.undeformed.size(), 18u);
  for (std::size_t i = 0; i < 18; ++i)
    EXPECT_LT((shown.undeformed[i].position - Vector3d(0, 0.25 * static_cast<double>(i % 9), 0)).norm(),
              1e-14);
  EXPECT_LT((a.find("link of A")->undeformed[1].position - Vector3d(0, 2, 0)).norm(), 1e-14);
  EXPECT_LT((a.find("Bob")->undeformed[1].position - Vector3d(0, 2, -0.5)).norm(), 1e-14);
}

/// The nodes are connected along the body, whatever their order.
TEST(picture_of, shows_flexible_bodies_by_their_nodes) {
  runtime::builder b("N");
  const auto N = runtime::builder::inertial_frame();
  const expression q = b.coordinate("q");
  b.kinematic_equation(b.dot(q) - b.speed("u"));
  mechanics::flexible_data data(1);
  data.mass = 1, data.modal_mass[0] = 1, data.stiffness[0] = 1;
  for (const int i : {0, 1, 2}) data.inertia.constant(i) = 1;
  for (const double x : {0.0, 2.0, 1.0}) {
    mechanics::flexible_node node{.called = base::name(x > 1   ? "far"
                                                       : x > 0 ? "middle"
                                                               : "near"),
                                  .position = mechanics::taylor_series(3, 1, 1)};
    node.position.constant(0) = x, node.position.linear(0, 1) = x * x;
    data.nodes.push(node);
  }
  b.flexible_body("Arm", b.origin("O"), N, {q}, data);
  const model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  const animation a = animated(m, positions(m, {}, {{0}, {0.1}}));
  ASSERT_TRUE(a) << a.cause();
  EXPECT_EQ(names_of(a), (std::vector<std::string>{"sphere: node near of Arm", "sphere: node far of Arm",
                                                   "sphere: node middle of Arm", "rod: Arm", "rod: Arm"}));
  EXPECT_LT((a.find("node far of Arm")->placements[1].position - Vector3d(2, 0.4, 0)).norm(), 1e-14);
  EXPECT_LT((a.shapes[3].placements[1].position - Vector3d(0, 0, 0)).norm(), 1e-14);
  EXPECT_LT((a.shapes[3].placements[1].end - Vector3d(1, 0.1, 0)).norm(), 1e-14);
  EXPECT_LT((a.shapes[4].placements[1].position - Vector3d(1, 0.1, 0)).norm(), 1e-14);
  EXPECT_LT((a.shapes[4].placements[1].end - Vector3d(2, 0.4, 0)).norm(), 1e-14);
}

TEST(picture_of, reports_why_there_is_no_picture) {
  runtime::builder b("N");
  const auto O = b.origin("O");
  const expression q = b.coordinate("q");
  b.kinematic_equation(b.dot(q) - b.speed("u"));
  const auto P = b.offset("P", O, b.along(runtime::builder::inertial_frame(), q, 0, 0));
  b.particle("Bob", P, b.number(1));
  const model m = derive(b);
  EXPECT_EQ(animated(m, positions(m, {}, {})).cause(), "the trajectory has no samples");
  EXPECT_EQ(animated(m, positions(m, {}, {{std::nan("")}})).cause(), "the state is not finite at t = 0");
  positions odd(m, {}, {{0.0}, {0.1}});
  odd.all[1].x.resize(5);
  EXPECT_EQ(animated(m, odd).cause(),
            "the state at t = 1 has 5 entries, but the model has 2 coordinates and speeds");
  odd.all[1].x.setZero(2), odd.all[1].r.setZero(1);
  EXPECT_EQ(animated(m, odd).cause(), "the input vector at t = 1 has 1 entry, but the model has 0 inputs");
  b.particle("Bob", P, b.number(1));
  EXPECT_EQ(animated(derive(b), positions(m, {}, {{0.0}})).cause(), "two bodies are called Bob");
}

} // namespace
