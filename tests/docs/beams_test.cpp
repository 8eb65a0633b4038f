// builds: clang++ all
// Beams: docs/guide/beams.md.
#include "docs/no_mistake.hpp"
#include "docs/text.hpp"

#include <kanexpr/beams.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <utility>

namespace {

using namespace kanexpr;
using docs::expect_no_mistake;

namespace arm {

#include <docs/guide/beams/arm.cpp>

TEST(beams, stiffen_when_they_rotate) {
  expect_no_mistake<System>();
  auto model = derive<System>();
  EXPECT_EQ(symbolic::print(model.mass_matrix(), "M = ") + "\n" + symbolic::print(model.forcing(), "f = ") +
                "\n",
            docs::text("docs/guide/beams/printed.text"));
}

} // namespace arm

// Declarations that the snippets use.
namespace given {

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"L"> L;
constexpr parameter<"rho"> rho;
constexpr parameter<"EI"> EI;
constexpr parameter<"GJ"> GJ;
constexpr parameter<"EA"> EA;
constexpr parameter<"J"> J;
struct N : inertial_ground<N> {};
struct O : origin<O, N> {};
struct R : rotated<R, N, q, N::z> {};
struct Root : offset<Root, O, 0.4 * R::x> {};
struct Base : planar<Base, N, axis<own::x, own::y>> {};
struct Pin : pin<Pin, N, axis<N::z>> {};

} // namespace given

namespace blade {

using namespace given;

#include <docs/guide/beams/blade.cpp>
struct End : section<End, Blade, 1> {};
#include <docs/guide/beams/places.cpp>
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, joints<Motor>,
                            bodies<Blade, Winglet>, loads<gravity<-9.81 * N::z>>> {};

TEST(beams, carry_joints_and_beams) {
  expect_no_mistake<System>();
  EXPECT_EQ(derive<System>().udot().rows, 8);
}

} // namespace blade

namespace shapes {

using namespace given;

#include <docs/guide/beams/crane.cpp>
#include <docs/guide/beams/rods.cpp>
struct Crane : kane_system<inertial<N>, bodies<Boom, Load>> {};
struct Others : kane_system<inertial<N>, joints<Base, Pin>, bodies<Rod, Lath, Bar, Slat, Beam, Spar>> {};

TEST(beams, take_shapes_of_many_kinds) {
  expect_no_mistake<Crane>();
  EXPECT_EQ(derive<Crane>().mistake(), "");
  EXPECT_EQ(derive<Others>().mistake(), "");
}

} // namespace shapes

TEST(beams, are_built_at_run_time) {
  runtime::builder b("N");
  const auto q = b.coordinate("q"), q1 = b.coordinate("q1"), q2 = b.coordinate("q2"), EI = b.parameter("EI");
  for (const auto& [of, called] : {std::pair{q, "u"}, std::pair{q1, "u1"}, std::pair{q2, "u2"}})
    b.kinematic_equation(b.dot(of) - b.speed(called));
  const auto hub = b.rotated("Hub", b.inertial_frame(), q, b.along(b.inertial_frame(), 0, 0, 1));
  const auto o = b.origin("O");
#include <docs/guide/beams/built.cpp>
  EXPECT_EQ(b.check().view(), "");
}

} // namespace
