// builds: clang++ all
// The contact points of wheels as words, compared with written points and with a builder.
#include <kanexpr/mechanics/loads/wheel_contact.hpp>
#include <kanexpr/mechanics/loads/wheel_on_ground.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic.hpp>
#include <kanexpr/tyres.hpp>
#include <kanexpr/wheels.hpp>
#include <models/bicycle.hpp>
#include <models/rolling_torus.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <random>

namespace {

using namespace kanexpr;
using Eigen::VectorXd;

void expect_same(model words, model written, int states, int parameters) {
  ASSERT_EQ(words.mistake(), "");
  ASSERT_EQ(written.mistake(), "");
  auto first = words.function(words.rhs()), second = written.function(written.rhs());
  std::mt19937_64 source(7);
  std::uniform_real_distribution<double> values(0.1, 0.9);
  for (int i = 0; i < 10; ++i) {
    const VectorXd state = VectorXd::NullaryExpr(states, [&] { return values(source); });
    const VectorXd p = VectorXd::NullaryExpr(parameters, [&] { return values(source); });
    EXPECT_LT((first(state, p) - second(state, p)).norm(), 1e-11 * second(state, p).norm());
  }
}

namespace torus {
using namespace rolling_torus;
struct Contact : contact_point<Contact, toroidal_wheel<by_rates::G, L::y, R, a, by_rates::B>,
                               flat_ground<by_rates::O, 3 * N::z>> {};
struct Words : lagrange_system<inertial<N>, coordinates<q1, q2, q3, by_rates::q4, by_rates::q5>,
                               velocity_constraints<zero_along<velocity_of<Contact>, N::x, N::y>>,
                               dependent<dot(by_rates::q4), dot(by_rates::q5)>, bodies<by_rates::Torus>,
                               loads<gravity<-g * N::z>>> {};
} // namespace torus

TEST(contact_points, of_a_torus_roll_as_in_the_textbook) {
  expect_same(derive<torus::Words>(), derive<rolling_torus::LagrangeSystem>(), 10, 4);
}

namespace front {
using namespace bicycle;
struct Contact : contact_point<Contact, thin_wheel<WF_mc, Fork::y, WFrad, WF>, flat_ground<WR_cont, Y::z>> {};
struct Words : kane_system<inertial<N>, coordinates<q1, q2, q5, q4>, speeds<u2, u3, u5, u1, u4, u6>,
                           kinematics<dot(q1) == u1, dot(q2) == u2, dot(q4) == u4, dot(q5) == u5>,
                           configuration_constraints<dot(position_of<Contact, WR_cont>, Y::z) == 0>,
                           velocity_constraints<zero_along<velocity_of<Contact>, Y::x, Y::y, Y::z>>,
                           dependent<u1, u4, u6, q4>, bodies<BodyFrame, BodyFork, BodyWR, BodyWF>,
                           loads<gravity<-g * N::z>>> {};
} // namespace front

TEST(contact_points, of_a_bicycle_are_the_written_ones) {
  expect_same(derive<front::Words>(), derive<bicycle::System>(), 10, 27);
}

namespace rim {
constexpr coordinate<"x"> x;
constexpr coordinate<"z"> z;
constexpr coordinate<"yaw"> yaw;
constexpr coordinate<"lean"> lean;
constexpr speed<"vx"> vx;
constexpr speed<"vz"> vz;
constexpr speed<"wyaw"> wyaw;
constexpr speed<"wlean"> wlean;
constexpr parameter<"r"> r;
struct N : inertial_frame<N> {};
struct Y : rotated<Y, N, yaw, N::z> {};
struct L : rotated<L, Y, lean, Y::x> {};
struct O : origin<O, N> {};
struct G : offset<G, O, x * N::x + z * N::z> {};
struct Body : rigid_body<Body, G, L, 2, inertia<L, 0.1, 0.2, 0.3>> {};

template <class Wheel, class Ground>
struct System : kane_system<inertial<N>, coordinates<x, z, yaw, lean>, speeds<vx, vz, wyaw, wlean>,
                            kinematics<dot(x) == vx, dot(z) == vz, dot(yaw) == wyaw, dot(lean) == wlean>,
                            parameters<r>, bodies<Body>,
                            loads<tyre<Wheel, Ground, linear_tyre<300, 500>, radial_stiffness<100, 0.1, 0.01>,
                                       standstill<0.1>>>> {};

/// The same system from a builder.
struct built : runtime::builder {
  mechanics::expression x = coordinate("x"), z = coordinate("z"), yaw = coordinate("yaw"),
                        lean = coordinate("lean"), r = parameter("r");
  runtime::frame_id n = inertial_frame(), l{};
  runtime::point_id o{}, g{};
  runtime::tyre_data forces = runtime::tyre_data::linear(300, 500);

  built() : builder("N") {
    kinematic_equation(dot(x) - speed("vx"));
    kinematic_equation(dot(z) - speed("vz"));
    kinematic_equation(dot(yaw) - speed("wyaw"));
    kinematic_equation(dot(lean) - speed("wlean"));
    const auto y = rotated("Y", n, yaw, along(n, 0, 0, 1));
    l = rotated("L", y, lean, along(y, 1, 0, 0));
    o = origin("O");
    g = offset("G", o, along(n, x, 0, z));
    rigid_body("Body", g, l, number(2), inertia(l, 0.1, 0.2, 0.3));
    forces.standstill = 0.1;
    forces.radial = {100.0, 0.1, 0.01};
  }
  runtime::wheel_data wheel(double tube, double conicity) {
    return {g, l, along(l, 0, 1, 0), r, tube, conicity};
  }
};
} // namespace rim

TEST(wheels, as_words_are_those_of_a_builder) {
  using namespace rim;
  using wavy = uneven_ground<O, N, 0.1 * sin(2 * surface::x) + 0.2 * surface::y * surface::y, 1>;
  built uneven;
  uneven.tyre(uneven.wheel_on_surface(
                  uneven.wheel(0.05, 0), uneven.o, uneven.n,
                  [](auto across, auto along) { return 0.1 * sin(2 * across) + 0.2 * along * along; }, 1),
              uneven.forces);
  expect_same(derive<rim::System<toroidal_wheel<G, L::y, r, 0.05, L>, wavy>>(), derive(uneven), 8, 1);
  built rail;
  rail.tyre(rail.wheel_on_rail(rail.wheel(0, 0.1),
                               {rail.o, rail.along(rail.n, 2, 0, 0), rail.along(rail.n, 0, 0, 1), 0.3}),
            rail.forces);
  expect_same(derive<rim::System<conical_wheel<G, L::y, r, 0.1, L>, straight_rail<O, 2 * N::x, N::z, 0.3>>>(),
              derive(rail), 8, 1);
}

/// A wheel that rolls on any ground.
namespace rim {
template <class Wheel, class Ground>
struct touching : contact_point<touching<Wheel, Ground>, Wheel, Ground> {};
template <class Wheel, class Ground>
struct Rolling
    : kane_system<inertial<N>, coordinates<x, z, yaw, lean>, speeds<vx, vz, wyaw, wlean>, kinematics<simple>,
                  parameters<r>, configuration_constraints<penetration_of<Wheel, Ground> == 0>,
                  velocity_constraints<dot(velocity_of<touching<Wheel, Ground>>, N::x) == 0>,
                  dependent<z, vz, vx>, bodies<Body>, loads<gravity<-9.81 * N::z>>> {};

/// The same system from a builder.
model rolling(built& b, const runtime::wheel_on_ground& wheel) {
  b.configuration_constraint(b.penetration_of(wheel));
  const auto contact = b.contact_point("Touching", wheel);
  mechanics::known_motion known(b.mechanism());
  b.velocity_constraint(b.velocity_of(contact, known), b.along(b.n, 1, 0, 0));
  b.dependent(b.z);
  b.dependent(b.mechanism().speeds[1]);
  b.dependent(b.mechanism().speeds[0]);
  b.gravity(b.along(b.n, 0, 0, -9.81));
  return derive(b);
}
} // namespace rim

TEST(contact_points, on_a_slope_are_those_of_a_plane) {
  using namespace rim;
  using round = toroidal_wheel<G, L::y, r, 0.05, L>;
  expect_same(derive<Rolling<round, uneven_ground<O, N, 0.2 * surface::x, 1>>>(),
              derive<Rolling<round, flat_ground<O, N::z - 0.2 * N::x>>>(), 8, 1);
}

TEST(contact_points, on_uneven_ground_and_rails_are_those_of_a_builder) {
  using namespace rim;
  built uneven, rail;
  expect_same(
      derive<Rolling<toroidal_wheel<G, L::y, r, 0.05, L>, uneven_ground<O, N, 0.1 * sin(2 * surface::x)>>>(),
      rolling(uneven, uneven.wheel_on_surface(uneven.wheel(0.05, 0), uneven.o, uneven.n,
                                              [](auto across, auto) { return 0.1 * sin(2 * across); })),
      8, 1);
  expect_same(derive<Rolling<conical_wheel<G, L::y, r, 0.1, L>, straight_rail<O, 2 * N::x, N::z, 0.3>>>(),
              rolling(rail, rail.wheel_on_rail(rail.wheel(0, 0.1), {rail.o, rail.along(rail.n, 2, 0, 0),
                                                                    rail.along(rail.n, 0, 0, 1), 0.3})),
              8, 1);
}

// While a wheel touches the ground, its lowest point moves into the ground as fast as the penetration grows.
TEST(contact_points, sink_as_fast_as_the_penetration_grows) {
  using namespace rim;
  for (const bool is_on_rail : {false, true}) {
    built b;
    const auto wheel =
        is_on_rail
            ? b.wheel_on_rail(b.wheel(0, 0.1), {b.o, b.along(b.n, 2, 0, 0), b.along(b.n, 0, 0, 1), 0.3})
            : b.wheel_on_surface(
                  b.wheel(0.05, 0), b.o, b.n,
                  [](auto across, auto along) { return 0.1 * sin(across) + 0.1 * along * along; }, 4);
    const auto contact = b.contact_point("Touching", wheel);
    mechanics::known_motion known(b.mechanism());
    runtime::vector normal;
    normal.add(wheel.other, wheel.contact(b.mechanism()).normal);
    symbolic::matrix all(b.graph(), 3, 1);
    all.entries[0] = b.penetration_of(wheel);
    all.entries[1] = b.derivative(all.entries[0], known);
    all.entries[2] = b.dot(b.velocity_of(contact, known), normal);
    model m = derive(b);
    ASSERT_EQ(m.mistake(), "");
    auto function = m.function(all);
    std::mt19937_64 source(7);
    std::uniform_real_distribution<double> values(-0.3, 0.3);
    for (int i = 0; i < 10; ++i) {
      VectorXd state = VectorXd::NullaryExpr(8, [&] { return values(source); });
      const VectorXd radius = VectorXd::Constant(1, 0.4);
      state(1) = 0.5;
      for (int k = 0; k < 60; ++k) state(1) += function(state, radius)(0);
      const VectorXd found = function(state, radius);
      EXPECT_NEAR(found(0), 0, 1e-12);
      EXPECT_NEAR(found(1), -found(2), 1e-9);
    }
  }
}

} // namespace
