// builds: clang++ all
#include "animate/samples.hpp"

#include <kanexpr/animate.hpp>
#include <kanexpr/contact.hpp>
#include <kanexpr/kanexpr.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;
using Eigen::Vector3d;
using testing::ElementsAre;

constexpr coordinate<"q"> q;
constexpr coordinate<"s"> s;
constexpr speed<"u"> u;
constexpr speed<"v"> v;
constexpr input<"F"> F;
constexpr input<"unused"> unused;
constexpr parameter<"g"> g;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct Middle : offset<Middle, O, 0.5 * A::x> {};
struct End : offset<End, O, A::x> {};
struct P : offset<P, O, s * N::x> {};
struct Rod : rigid_body<Rod, Middle, A, 3, inertia<A, 0.1, 0.25, 0.25>> {};
struct Bead : particle<Bead, P, 2> {};
struct System
    : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>, kinematics<dot(q) == u, dot(s) == v>,
                  inputs<F, unused>, bodies<Rod, Bead>,
                  loads<gravity<-g * N::y>, force<End, F * A::y>, force_between<P, Middle, -4 * N::z>,
                        drag<P, 0.5>, torque<A, unused * N::z>>> {};

using shown = picture<System, up<N::y>, show<rod<O, End, 0.1>>, show_forces<"N">, show_velocities<"m/s">,
                      show_frames, plot_energies<"J">, in_unit<"rad", q>, in_unit<"m/s", v>, in_unit<"N", F>,
                      plot<"height", dot(position_of<End, O>, N::y), "m">,
                      show<arrow<End, angular_velocity_of<A>>, named<"turning">, unit<"rad/s">>>;

tests::samples<System> motion() {
  tests::samples<System> run;
  run.p[g] = 10;
  for (double t : {0.0, 1.0, 2.0}) {
    tests::sample<System> one;
    one.t = t;
    one.x[q] = 0.3 * t, one.x[s] = 2 - t, one.x[u] = 0.3, one.x[v] = -1;
    one.r[F] = 5 + t;
    run.all.push_back(one);
  }
  return run;
}

TEST(vectors, are_the_forces_of_the_model_and_the_motions_of_its_bodies) {
  const animation a = animated<shown>(motion());
  ASSERT_TRUE(a) << a.cause();
  struct arrow_at {
    const char *name, *layer, *unit;
    Vector3d from, vector;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const double t = a.times[k], angle = 0.3 * t;
    const Vector3d x(std::cos(angle), std::sin(angle), 0), y(-std::sin(angle), std::cos(angle), 0);
    const Vector3d bead(2 - t, 0, 0);
    for (const arrow_at& wanted : {arrow_at{"force at End", "Forces", "N", x, (5 + t) * y},
                                   arrow_at{"force at P", "Forces", "N", bead, {0, 0, -4}},
                                   arrow_at{"force at Middle", "Forces", "N", 0.5 * x, {0, 0, 4}},
                                   arrow_at{"drag at P", "Forces", "N", bead, {0.5, 0, 0}},
                                   arrow_at{"weight of Rod", "Forces", "N", 0.5 * x, {0, -30, 0}},
                                   arrow_at{"weight of Bead", "Forces", "N", bead, {0, -20, 0}},
                                   arrow_at{"velocity of Rod", "Velocities", "m/s", 0.5 * x, 0.15 * y},
                                   arrow_at{"velocity of Bead", "Velocities", "m/s", bead, {-1, 0, 0}},
                                   arrow_at{"turning", "Vectors", "rad/s", x, {0, 0, 0.3}}}) {
      const animation::shape* found = a.find(wanted.name);
      ASSERT_NE(found, nullptr) << wanted.name;
      EXPECT_EQ(found->kind, "arrow");
      EXPECT_EQ(found->layer, wanted.layer);
      EXPECT_EQ(found->unit, wanted.unit);
      EXPECT_LT((found->placements[k].position - wanted.from).norm(), 1e-14) << wanted.name;
      EXPECT_LT((found->placements[k].end - wanted.vector).norm(), 1e-14) << wanted.name;
    }
    const animation::shape* axes = a.find("axes of A");
    ASSERT_NE(axes, nullptr);
    EXPECT_EQ(axes->layer, "Frames");
    EXPECT_LT((axes->placements[k].orientation.col(1) - y).norm(), 1e-14);
  }
  EXPECT_EQ(a.shapes.size(), 11u); // the rod, nine arrows, and the axes of the only rigid body
}

TEST(columns, are_the_state_the_inputs_with_values_the_energies_and_plots) {
  const animation a = animated<shown>(motion());
  ASSERT_TRUE(a) << a.cause();
  std::vector<std::string> titles;
  for (const animation::column& c : a.columns) titles.push_back(c.group + ": " + c.name + ", " + c.unit);
  EXPECT_THAT(titles,
              ElementsAre("Coordinates: q, rad", "Coordinates: s, ", "Speeds: u, ", "Speeds: v, m/s",
                          "Inputs: F, N", "Energies: kinetic energy, J", "Energies: potential energy, J",
                          "Energies: total energy, J", "Quantities: height, m"));
  const double kinetic = 0.5 * 3 * 0.15 * 0.15 + 0.5 * 0.25 * 0.3 * 0.3 + 0.5 * 2;
  for (std::size_t k = 0; k < 3; ++k) {
    const double t = a.times[k], potential = 3 * 10 * 0.5 * std::sin(0.3 * t);
    EXPECT_EQ(a.columns[4].values[k], 5 + t);
    EXPECT_NEAR(a.columns[5].values[k], kinetic, 1e-14);
    EXPECT_NEAR(a.columns[6].values[k], potential, 1e-13);
    EXPECT_NEAR(a.columns[7].values[k], kinetic + potential, 1e-13);
    EXPECT_NEAR(a.columns[8].values[k], std::sin(0.3 * t), 1e-15);
  }
}

TEST(vectors, are_checked_for_finite_numbers) {
  tests::samples<System> run = motion();
  run.all[1].r[F] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(animated<shown>(run).cause(), "the vector of the force at End is not finite at t = 1");
}

template <class... Elements>
constexpr std::string_view mistake_with() {
  return picture<System, up<N::y>, show<rod<O, End, 0.1>>, Elements...>::mistake.view();
}

TEST(picture_check, wants_plots_of_scalars_and_arrows_along_vectors) {
  EXPECT_EQ((mistake_with<plot<"height", position_of<End, O>>>()),
            "the plot of height is a vector; it must be a scalar");
  EXPECT_EQ((mistake_with<plot<"", q>>()), "a plot has no name");
  EXPECT_EQ((mistake_with<show<arrow<End, q>>>()),
            "the vector of the arrow at End is a scalar; it must be a vector");
}

TEST(picture_check, wants_units_of_what_varies) {
  EXPECT_EQ(
      (mistake_with<in_unit<"kg", g>>()),
      "the unit kg is given for the parameter g; it may be given only for coordinates, speeds and inputs");
  EXPECT_EQ((mistake_with<in_unit<"m", q * s>>()),
            "the unit m is given for an expression; it may be given only for coordinates, speeds and inputs");
  EXPECT_EQ((mistake_with<in_unit<"rad/s", dot(q)>>()), "");
}

TEST(picture_check, wants_each_layer_once) {
  EXPECT_EQ((mistake_with<show_forces<>, show_forces<"N">>()), "the picture lists show_forces<...> twice");
}

namespace on_a_slope {

constexpr parameter<"r"> r;
constexpr parameter<"k"> k;
constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr coordinate<"angle"> angle;
constexpr speed<"vx"> vx;
constexpr speed<"vy"> vy;
constexpr speed<"w"> w;

struct B : rotated<B, N, angle, N::z> {};
struct C : offset<C, O, x * N::x + y * N::y> {};
struct Ball : rigid_body<Ball, C, B, 2, inertia<B, 0.1, 0.1, 0.1>> {};
struct Rolling
    : kane_system<inertial<N>, coordinates<x, y, angle>, speeds<vx, vy, w>, kinematics<simple>, bodies<Ball>,
                  loads<contact<sphere_on_plane<C, r, O, 3.0 * N::x + 4.0 * N::y, B>, elastic<k>,
                                smoothed_over<1e-3>, dissipation<0.2>, coulomb_friction<0.5, 0.01>>>> {};
using picture = kanexpr::picture<Rolling, up<N::y>, show<sphere<C, r>>, show_forces<"N">>;

} // namespace on_a_slope

namespace on_a_cable {

using namespace kanexpr;

struct Q : offset<Q, O, 3.0 * N::x + 4.0 * N::y> {};
struct Eye : offset<Eye, O, 3.0 * N::x> {};
using Cable = through<P, Eye, Q>;
struct Hanging : kane_system<inertial<N>, coordinates<s>, speeds<v>, kinematics<dot(s) == v>, bodies<Bead>,
                             loads<linear_spring<Cable, 10, 3.0>, spring<P, Q, 7, 2.0>, damper<P, O, 2>>> {};
using picture = kanexpr::picture<Hanging, up<N::y>, show<sphere<P, 0.1>>, show_forces<"N">>;

} // namespace on_a_cable

/// A cable and a spring pull their ends together; a damper resists their motion.
TEST(vectors, are_the_tensions_of_cables_springs_and_dampers) {
  using namespace on_a_cable;
  tests::samples<Hanging> run;
  run.all.push_back({0.0, {{s, 1.0}, {v, -0.5}}, {}});
  const animation a = animated<on_a_cable::picture>(run);
  ASSERT_TRUE(a) << a.cause();
  struct arrow_at {
    const char* name;
    Vector3d from, vector;
  };
  const Vector3d p(1, 0, 0), end(3, 4, 0), along = (end - p).normalized();
  const double pulled = 7 * ((end - p).norm() - 2);
  const std::vector<arrow_at> wanted{
      {"tension at P", p, {30, 0, 0}},     {"tension at Q", end, {0, -30, 0}},
      {"tension at P", p, pulled * along}, {"tension at Q", end, -pulled * along},
      {"tension at P", p, {1, 0, 0}},      {"tension at O", {0, 0, 0}, {-1, 0, 0}}};
  std::vector<const animation::shape*> found;
  for (const animation::shape& each : a.shapes)
    if (each.name.starts_with("tension")) found.push_back(&each);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i]->name, wanted[i].name);
    EXPECT_EQ(found[i]->layer, "Forces");
    EXPECT_LT((found[i]->placements[0].position - wanted[i].from).norm(), 1e-14) << i;
    EXPECT_LT((found[i]->placements[0].end - wanted[i].vector).norm(), 1e-12) << i;
  }
}

/// At rest, the contact is pressed by k δ; the friction opposes the slip.
TEST(vectors, are_the_forces_of_contacts) {
  using namespace on_a_slope;
  tests::samples<Rolling> run;
  run.p = {{r, 0.5}, {k, 1000}};
  const Vector3d normal(0.6, 0.8, 0), down(0.8, -0.6, 0);
  for (const double sliding : {0.0, 0.3}) {
    const Vector3d place = 0.48 * normal + 2 * down;
    run.all.push_back({sliding,
                       {{x, place(0)},
                        {y, place(1)},
                        {on_a_slope::angle, 0.3},
                        {vx, sliding * down(0)},
                        {vy, sliding * down(1)},
                        {w, 0}},
                       {}});
  }
  const animation a = animated<on_a_slope::picture>(run);
  ASSERT_TRUE(a) << a.cause();
  const animation::shape* force = a.find("contact force at C");
  ASSERT_NE(force, nullptr);
  EXPECT_EQ(force->layer, "Forces");
  const Vector3d touching = (0.48 - 0.5) * normal + 2 * down;
  const double friction = 0.5 * 20 * 0.3 / std::hypot(0.3, 0.01);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((force->placement_at(i).position - touching).norm(), 1e-14);
    const Vector3d expected = 20 * normal - (i == 0 ? 0 : friction) * down;
    EXPECT_LT((force->placement_at(i).end - expected).norm(), 1e-12);
  }
}

} // namespace
