// The contact points of wheels as words, compared with written points and with a builder.
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

} // namespace
