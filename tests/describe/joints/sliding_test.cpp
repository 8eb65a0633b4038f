// builds: clang++ sanitize all
#include "describe/joints/by_hand.hpp"

// Joints whose two points move apart, with locations away from both points.
namespace {

using namespace by_hand;

namespace slider {
struct Link : prismatic<Link, Ground, axis<0.6 * own::x + 0.8 * own::z>, seat, home<0.7, Ground::z>, load> {};
struct Hanging : pin<Hanging, Link, axis<own::x>, at<0.1 * Link::y>, load> {};
struct System : kane_system<inertial<Ground>, joints<Link, Hanging>, loads<weight>> {};

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
struct Child : rotated<Child, Ground, 0.7, Ground::z> {};
struct Base : offset<Base, Ground, seat::in_parent> {};
struct Joint : offset<Joint, Base, q * (0.6 * Child::x + 0.8 * Child::z)> {};
struct Point : offset<Point, Joint, from_joint<Child>> {};
struct Center : offset<Center, Point, center_of<Child>> {};
struct Body : load_of<Body, Center, Child> {};
struct Second : rotated<Second, Child, s, Child::x> {};
struct Second_point : offset<Second_point, Point, 0.1 * Child::y> {};
struct Second_center : offset<Second_center, Second_point, center_of<Second>> {};
struct Second_body : load_of<Second_body, Second_center, Second> {};
struct Hand : kane_system<inertial<Ground>, coordinates<q, s>, speeds<u, v>, kinematics<simple>,
                          bodies<Body, Second_body>, loads<weight>> {};
} // namespace slider

TEST(prismatic, goes_along_its_axis) { expect_same_motion<slider::System, slider::Hand>(); }

namespace sleeve {
struct Link : cylindrical<Link, Ground, axis<Ground::y>, seat, load> {};
struct System : kane_system<inertial<Ground>, joints<Link>, loads<weight>> {};

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
struct Child : rotated<Child, Ground, q, Ground::y> {};
struct Base : offset<Base, Ground, seat::in_parent> {};
struct Joint : offset<Joint, Base, s * Ground::y> {};
struct Point : offset<Point, Joint, from_joint<Child>> {};
struct Center : offset<Center, Point, center_of<Child>> {};
struct Body : load_of<Body, Center, Child> {};
struct Hand : kane_system<inertial<Ground>, coordinates<q, s>, speeds<u, v>,
                          kinematics<dot(q) == u, dot(s) == v>, bodies<Body>, loads<weight>> {};
} // namespace sleeve

TEST(cylindrical, turns_about_and_goes_along_its_axis) { expect_same_motion<sleeve::System, sleeve::Hand>(); }

namespace puck {
struct Link : planar<Link, Ground, axis<Ground::z, Ground::x>, seat, load> {};
struct System : kane_system<inertial<Ground>, joints<Link>, loads<weight>> {};

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr coordinate<"q3"> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
struct Child : rotated<Child, Ground, q3, Ground::y> {};
struct Base : offset<Base, Ground, seat::in_parent> {};
struct Joint : offset<Joint, Base, q1 * Ground::z + q2 * Ground::x> {};
struct Point : offset<Point, Joint, from_joint<Child>> {};
struct Center : offset<Center, Point, center_of<Child>> {};
struct Body : load_of<Body, Center, Child> {};
struct Hand : kane_system<inertial<Ground>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>, kinematics<simple>,
                          bodies<Body>, loads<weight>> {};
} // namespace puck

TEST(planar, goes_in_a_plane_and_turns_about_its_normal) { expect_same_motion<puck::System, puck::Hand>(); }

// A floating base with a second floating base that moves relative to it, in a rotating frame.
namespace flying {
struct Carrier : floating<Carrier, Ground, load> {};
struct Passenger : floating<Passenger, Carrier, angles<"zyx">, at<0.2 * Carrier::x>, load> {};
struct System : kane_system<inertial<Ground>, joints<Carrier, Passenger>, loads<weight>> {};

constexpr coordinate<"p1"> p1;
constexpr coordinate<"p2"> p2;
constexpr coordinate<"p3"> p3;
constexpr coordinate<"e1"> e1;
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr coordinate<"r1"> r1;
constexpr coordinate<"r2"> r2;
constexpr coordinate<"r3"> r3;
constexpr coordinate<"a1"> a1;
constexpr coordinate<"a2"> a2;
constexpr coordinate<"a3"> a3;
template <int i>
constexpr speed<"u", i> u;
struct A : quaternion<A, Ground, e0, e1, e2, e3>,
           angular_velocity<Ground, u<4> * own::x + u<5> * own::y + u<6> * own::z> {};
constexpr auto v = u<1> * A::x + u<2> * A::y + u<3> * A::z;
struct P : offset<P, Ground, p1 * Ground::x + p2 * Ground::y + p3 * Ground::z>, velocity<Ground, v> {};
struct A_center : offset<A_center, P, center_of<A>> {};
struct A_body : load_of<A_body, A_center, A> {};
struct B : body_fixed<B, A, "zyx", a1, a2, a3>,
           angular_velocity<A, u<10> * own::x + u<11> * own::y + u<12> * own::z> {};
constexpr auto w = u<7> * B::x + u<8> * B::y + u<9> * B::z;
struct Base : offset<Base, P, 0.2 * A::x> {};
struct Q : offset<Q, Base, r1 * A::x + r2 * A::y + r3 * A::z>, velocity<A, w> {};
struct B_center : offset<B_center, Q, center_of<B>> {};
struct B_body : load_of<B_body, B_center, B> {};
struct Hand
    : kane_system<inertial<Ground>, coordinates<p1, p2, p3, e1, e2, e3, e0, r1, r2, r3, a1, a2, a3>,
                  speeds<u<1>, u<2>, u<3>, u<4>, u<5>, u<6>, u<7>, u<8>, u<9>, u<10>, u<11>, u<12>>,
                  kinematics<dot(p1) == dot(v, Ground::x), dot(p2) == dot(v, Ground::y),
                             dot(p3) == dot(v, Ground::z), kinematics_of<A, Ground>, dot(r1) == dot(w, A::x),
                             dot(r2) == dot(w, A::y), dot(r3) == dot(w, A::z), kinematics_of<B, A>>,
                  bodies<A_body, B_body>, loads<weight>> {};
} // namespace flying

TEST(floating, moves_freely_in_its_parent) { expect_same_motion<flying::System, flying::Hand>(); }

} // namespace
