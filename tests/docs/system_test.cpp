// A system and its parts: the pages vectors, frames, points, masses, forces and kanes-equations of
// docs/guide.
#include "docs/complete.hpp"
#include "docs/no_mistake.hpp"

namespace {

using namespace kanexpr;

using docs::expect_no_mistake;

// Declarations that the snippets use.
namespace given {

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr coordinate<"q3"> q3;
constexpr coordinate<"q4"> q4;
constexpr coordinate<"e0"> e0;
constexpr coordinate<"e1"> e1;
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"x"> x;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"u4"> u4;
constexpr speed<"v1"> v1;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr parameter<"l0"> l0;
constexpr parameter<"r"> r;
constexpr parameter<"g"> g;
constexpr parameter<"k"> k;
constexpr parameter<"c"> c;
constexpr parameter<"w"> w;
constexpr parameter<"I"> I;
constexpr parameter<"J"> J;
constexpr parameter<"Ixx"> Ixx;
constexpr parameter<"Iyy"> Iyy;
constexpr parameter<"Izz"> Izz;
constexpr input<"F"> F;
constexpr input<"T"> T;
constexpr prescribed<"s"> s;

} // namespace given

namespace symbols {

#include <docs/guide/vectors/symbols.cpp>

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, (q<1> + theta) * N::x> {};
struct Bead : particle<Bead, P, m> {};
struct System : kane_system<inertial<N>, coordinates<q<1>>, speeds<u1>, kinematics<dot(q<1>) == u1>,
                            bodies<Bead>, loads<force<P, F * t * N::x>>> {};

TEST(systems, are_symbols) {
  expect_no_mistake<System>();
  EXPECT_EQ(symbolic::print(derive<System>().qdot()), "[u1]");
}

} // namespace symbols

namespace frames {

using namespace given;

#include <docs/guide/frames/orientations.cpp>

struct O : origin<O, N> {};
struct P : offset<P, O, B::x + C::y + D::z> {};
struct Q : offset<Q, O, E::y> {};
struct Bead : particle<Bead, P, m> {};
struct Other : particle<Other, Q, m> {};
struct System : kane_system<inertial<N>, coordinates<q1, q2, q3, e0, e1, e2, e3>,
                            speeds<u1, u2, u3, u4, v1, speed<"v2">{}>,
                            kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3, dot(e0) == 0.0,
                                       dot(e1) == u4, dot(e2) == v1, dot(e3) == speed<"v2">{}>,
                            bodies<Bead, Other>> {};

TEST(systems, are_frames) { expect_no_mistake<System>(); }

} // namespace frames

namespace points {

using namespace given;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q1, N::z> {};
struct L : rotated<L, N, q2, N::x> {};
struct R : rotated<R, L, q3, L::y> {};
struct B : rotated<B, A, q4, A::z> {};
struct C : origin<C, N> {};

#include <docs/guide/points/points.cpp>

struct First : particle<First, Q, m> {};
struct Second : particle<Second, G, m> {};
struct Third : particle<Third, B0, m> {};
struct System
    : kane_system<inertial<N>, coordinates<q1, q2, q3, q4, x>, speeds<u1, u2, u3, v1>,
                  kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3, dot(q4) == v1, dot(x) == v1>,
                  bodies<First, Second, Third>> {};

TEST(systems, are_points) { expect_no_mistake<System>(); }

} // namespace points

namespace bodies_and_loads {

using namespace given;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q1, N::y> {};
struct B : rotated<B, A, q2, A::z> {};
struct L : rotated<L, N, q3, N::x> {};
struct R : rotated<R, L, q4, L::y> {};
struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};
struct Q : offset<Q, O, l * N::y> {};
struct G : offset<G, O, 0.0 * N::x> {};
struct Beyond : rigid_body<Beyond, G, B, m, inertia<B, 0, 0, I>> {};

#include <docs/guide/masses/bodies.cpp>

template <class Loads>
struct system : kane_system<inertial<N>, coordinates<q1, q2, q3, q4>, speeds<u1, u2, u3, u4>,
                            kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3, dot(q4) == u4>,
                            bodies<Bob, Link, Rod, Wheel, Beyond>, Loads> {};

TEST(systems, are_bodies_and_loads) {
  expect_no_mistake<system<
#include <docs/guide/forces/loads.cpp>
      >>();
  expect_no_mistake<system<loads<
#include <docs/guide/forces/between.cpp>
      >>>();
  expect_no_mistake<system<loads<
#include <docs/guide/forces/motion.cpp>
      >>>();
}

} // namespace bodies_and_loads

namespace rocket {

using given::g;
using given::x;
constexpr speed<"u"> u;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::z> {};

#include <docs/guide/masses/rocket.cpp>

TEST(systems, are_a_rocket) {
  state<System> now{{x, 0}, {u, 100}};
  input_values<System> r;
#include <docs/guide/masses/burning.cpp>
  const parameter_values<System> p{{g, 9.81}};
  EXPECT_NEAR(equations_of_motion<System>::udot(now, p, r)[0], 3000 * 2.23 / 39.4 - 9.81, 1e-9);
}

} // namespace rocket

namespace tube {

using given::m;
constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};

#include <docs/guide/points/tube.cpp>

TEST(systems, are_a_tube) {
  state<System> x{{q, 2}, {u, 0}};
  input_values<System> r;
#include <docs/guide/points/turning.cpp>
  const parameter_values<System> p{{m, 3}};
  EXPECT_NEAR(equations_of_motion<System>::udot(x, p, r)[0], 2 * 2.94 * 2.94, 1e-9);
}

} // namespace tube

namespace whole {

using namespace given;
constexpr speed<"u"> u;
struct N : inertial_frame<N> {};
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};
struct Q : offset<Q, P, l * B::x> {};
struct Link : rigid_body<Link, Q, B, m, inertia<B, 0, 0, m * l * l>> {};
struct Bob : particle<Bob, P, m> {};

#include <docs/guide/kanes-equations/system.cpp>

TEST(systems, are_a_system) { expect_no_mistake<System>(); }

#include <docs/guide/kanes-equations/extended.cpp>

TEST(systems, extend_a_system) {
  const auto pushed = derive<Pushed>();
  EXPECT_EQ(pushed.mistake(), "");
  EXPECT_EQ(input_values<Pushed>::SizeAtCompileTime, 2);
}

} // namespace whole

namespace orientations {

using namespace given;
struct N : inertial_frame<N> {};

#include <docs/guide/kanes-equations/angular_velocities.cpp>

struct C : origin<C, N> {};
struct Angles : rigid_body<Angles, C, B, m, inertia<B, I, I, I>> {};
struct Turns : rigid_body<Turns, C, R, m, inertia<R, I, I, I>> {};
struct Quaternion : rigid_body<Quaternion, C, Q, m, inertia<Q, I, I, I>> {};

struct OfAngles : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                              kinematics<kinematics_of<B, N>>, bodies<Angles>> {};
struct OfTurns : kane_system<inertial<N>, coordinates<q1, q2, q3, q4>, speeds<u1, u2, u3, u4>,
#include <docs/guide/kanes-equations/kinematics_of.cpp>
                             , bodies<Turns>, loads<potential_energy<q4 * q4>>> {
};
struct OfQuaternion : kane_system<inertial<N>, coordinates<e0, e1, e2, e3>, speeds<u1, u2, u3>,
                                  kinematics<kinematics_of<Q, N>>, bodies<Quaternion>> {};

TEST(systems, are_orientations) {
  expect_no_mistake<OfAngles>();
  expect_no_mistake<OfTurns>();
  expect_no_mistake<OfQuaternion>();
  auto model = derive<OfTurns>();
  EXPECT_EQ(symbolic::print(model.qdot()), "[u3/cos(q2)             ]\n[u1                     ]\n"
                                           "[u2 - u3*sin(q2)/cos(q2)]\n[u4                     ]");
}

} // namespace orientations

namespace wheel {

using namespace given;
struct N : inertial_frame<N> {};
struct Frame : rotated<Frame, N, q1, N::x> {};

#include <docs/guide/frames/wheel.cpp>

struct C : origin<C, N> {};
struct Body : rigid_body<Body, C, Wheel, m, inertia<Frame, I, J, I>> {};
struct System
    : kane_system<inertial<N>, coordinates<q1>, speeds<u1, u3>, kinematics<dot(q1) == u1>, bodies<Body>> {};

TEST(systems, are_a_wheel) { expect_no_mistake<System>(); }

} // namespace wheel
} // namespace
