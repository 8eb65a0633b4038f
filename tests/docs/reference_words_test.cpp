// builds: clang++ all
// Examples of single words of a model and of its figure: docs/reference/examples.md.
#include "docs/complete.hpp"
#include "docs/no_mistake.hpp"

#include <kanexpr/figures.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/reactions.hpp>

namespace {

using namespace kanexpr;

// What the snippets take for given.
constexpr coordinate<"q"> q;
constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr coordinate<"q3"> q3;
constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"u"> u;
constexpr parameter<"a"> a;
constexpr parameter<"b"> b;
constexpr parameter<"k"> k;
constexpr parameter<"m"> m;
constexpr parameter<"r"> r;
constexpr parameter<"I"> I;
constexpr parameter<"J"> J;
constexpr input<"F"> F;
struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct Spun : rotated<Spun, A, q1, A::y> {};
struct O : origin<O, N> {};
struct P : offset<P, O, A::x> {};
struct Bob : particle<Bob, P, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, F * N::x>>> {};

#include <docs/reference/examples/expressions.cpp>

#include <docs/reference/examples/angles.cpp>
#include <docs/reference/examples/columns.cpp>
#include <docs/reference/examples/corners.cpp>
#include <docs/reference/examples/gimbal.cpp>
#include <docs/reference/examples/growth.cpp>
#include <docs/reference/examples/moment.cpp>
#include <docs/reference/examples/motion.cpp>

#include <docs/reference/examples/apart.cpp>
#include <docs/reference/examples/changing.cpp>
#include <docs/reference/examples/extended.cpp>

static_assert(docs::complete<Gimbal, Shaft, Contact, Disc, Observed, Guided>);
static_assert(is_equation(rate == u) && columns_of(jacobian(velocity_of<P>, u, q)) == 2);

TEST(reference, names_expressions) {
#include <docs/reference/examples/name.cpp>
  EXPECT_EQ(known, read);
  model of = derive<System>();
  EXPECT_EQ(symbolic::print(of.get<energy(u)>()), "[m*u^2/2]");
}

TEST(reference, moves) {
  using eom = equations_of_motion<System>;
  const eom::state at{{q, 0}, {u, 2}};
  const eom::parameters p{{m, 1}};
  EXPECT_NEAR(velocity_in_A(at, p)(1), 2, 1e-15);
  EXPECT_NEAR(partial_velocity(at, p)(1), 1, 1e-15);
  EXPECT_EQ((derive<System, square(velocity_of<P>), about_z(outer(N::z, N::z)), moment>().mistake()), "");
}

TEST(reference, has_figures) {
#include <docs/reference/examples/figure.cpp>
  EXPECT_TRUE(drawing) << drawing.cause();
}

} // namespace

namespace joints_of_the_reference {

using namespace kanexpr;

constexpr parameter<"m"> m;
constexpr parameter<"I"> I;
constexpr parameter<"J"> J;
struct Ground : inertial_ground<Ground> {};

#include <docs/reference/examples/joints.cpp>

struct Mechanism : kane_system<inertial<Ground>, joints<Slide, Nut, Cross, Puck, Shoulder, Plate>> {};

TEST(reference, has_joints) { docs::expect_no_mistake<Mechanism>(); }

struct Motor : pin<Motor, Ground, axis<Ground::z>, body<1, 0.0 * own::x, inertia<own, 1, 1, 1>>> {};
struct Drum
    : pin<Drum, Ground, axis<Ground::z>, at<Ground::x>, body<1, 0.0 * own::x, inertia<own, 1, 1, 1>>> {};
struct Rack : prismatic<Rack, Ground, axis<Ground::x>, at<Ground::y>, body<1, 0.0 * own::x>> {};

#include <docs/reference/examples/couplings.cpp>

static_assert(docs::complete<train, belts, racks, linkage, guide, welded>);

struct Wound : kane_system<inertial<Ground>, joints<Motor, Drum, Rack>, train> {};
struct Belted : kane_system<inertial<Ground>, joints<Motor, Drum, Rack>, belts> {};
struct Racked : kane_system<inertial<Ground>, joints<Motor, Drum, Rack>, racks> {};

TEST(reference, has_couplings) {
  docs::expect_no_mistake<Wound>();
  docs::expect_no_mistake<Belted>();
  docs::expect_no_mistake<Racked>();
}

struct System : kane_system<inertial<Ground>, joints<Motor, Drum>, loads<gravity<-9.81 * Ground::z>>> {};
const equations_of_motion<System>::state x;

#include <docs/reference/examples/reactions.cpp>

TEST(reference, has_reactions) {
  docs::expect_no_mistake<Measured>();
  EXPECT_NEAR(at_the_drum.force.z(), 9.81, 1e-12);
}

} // namespace joints_of_the_reference
