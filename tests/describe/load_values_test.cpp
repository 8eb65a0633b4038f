// builds: clang++ all
// Pathways, contacts and friction with values that are meaningless; the systems are derived at run time. The
// compiler reports some of them in tests/mistakes.
#include <kanexpr/blocks.hpp>
#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/symbolic.hpp>
#include <kanexpr/tyres.hpp>

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace {

using namespace kanexpr;

constexpr input<"T"> T;
constexpr time_variable t;
constexpr parameter<"l"> l;

struct Ground : inertial_ground<Ground> {};
using mass = body<2, 0.3 * own::x, inertia<own, 1, 1, 1>>;
struct Arm : pin<Arm, Ground, axis<own::z>, mass> {};
struct Ball : floating<Ball, Ground, mass> {};
struct P : offset<P, Arm, 0.5 * Arm::x> {};
struct P2 : offset<P2, Arm, 0.5 * Arm::x + 0.1 * Arm::y> {};
struct H : offset<H, Ground, 2.0 * Ground::x> {};

template <class... Loads>
struct moved : kane_system<inertial<Ground>, joints<Arm, Ball>, used_elsewhere<T>, loads<Loads...>> {};

template <class... Loads>
std::string mistake() {
  return derive<moved<Loads...>>().mistake();
}

template <class Shapes>
using touching = contact<Shapes, elastic<100>, smoothed_over<0.001>>;
using on_floor = sphere_on_plane<Ball, 0.1, Ground, Ground::z>;
template <class... Words>
std::string mistake_on_floor() {
  return mistake<contact<on_floor, elastic<100>, smoothed_over<0.001>, Words...>>();
}

TEST(values_of_loads, friction_that_drives) {
  EXPECT_EQ((mistake_on_floor<coulomb_friction<-0.5, 0.01>>()),
            "the coefficient of friction of the contact between Ball and Ground is negative");
  EXPECT_EQ((mistake_on_floor<stribeck_friction<0.1, 0.5, 0.01>>()),
            "the coefficient of static friction of the contact between Ball and Ground is less than that of "
            "sliding friction");
  EXPECT_EQ((mistake_on_floor<viscous_friction<-1>>()),
            "the viscous coefficient of the contact between Ball and Ground is negative");
  EXPECT_EQ((mistake_on_floor<rolling_resistance<-0.1, 0.1>>()),
            "the lever of the rolling resistance between Ball and Ground is negative");
  EXPECT_EQ((mistake_on_floor<spinning_resistance<-0.1, 0.1>>()),
            "the lever of the spinning resistance between Ball and Ground is negative");
  EXPECT_EQ((mistake_on_floor<dissipation<-1>>()),
            "the damping of the contact between Ball and Ground is negative");
  EXPECT_EQ((mistake_on_floor<restitution<0.5, -1>>()),
            "the approach speed of the contact between Ball and Ground is not positive");
  EXPECT_EQ((mistake<friction<Arm, 1, coulomb_friction<-0.3, 0.1>>>()),
            "the coefficient of friction of the friction between Arm and Ground is negative");
  EXPECT_EQ((mistake<friction<Arm, -1, coulomb_friction<0.3, 0.1>>>()),
            "the normal force of the friction between Arm and Ground is negative");
  EXPECT_EQ((mistake<friction<straight<P, H>, -1, viscous_friction<0.3>>>()),
            "the normal force of the friction between P and H is negative");
  EXPECT_EQ((mistake<friction<Arm, 1, coulomb_friction<0.3, 0.0>>>()),
            "the slip speed of the friction between Arm and Ground is not positive");
  EXPECT_EQ((mistake<friction<Arm, 1, coulomb_friction<0.3, u_of<Arm>>>>()),
            "the slip speed of the friction between Arm and Ground contains the speed u_Arm; it may contain "
            "only parameters, inputs and time");
}

TEST(values_of_loads, shapes_that_do_not_exist) {
  EXPECT_EQ((mistake<touching<sphere_on_plane<Ball, -0.1, Ground, Ground::z>>>()),
            "the radius of the contact between Ball and Ground is negative");
  EXPECT_EQ((mistake<touching<torus_on_plane<Ball, Ball::y, -0.3, 0.05, Ground, Ground::z>>>()),
            "the second radius of the contact between Ball and Ground is negative");
  EXPECT_EQ((mistake<touching<torus_on_plane<Ball, Ground::z, 0.3, 0.05, Ground, Ground::z>>>()),
            "the axis of the torus of the contact between Ball and Ground is parallel to the normal");
  EXPECT_EQ((mistake<touching<point_on_plane<H, Ground, Ground::z>>>()),
            "the bodies of the contact between H and Ground never move relative to each other");
  EXPECT_EQ((mistake<touching<point_on_plane<P, P2, Arm::z>>>()),
            "the bodies of the contact between P and P2 never move relative to each other");
  EXPECT_EQ((mistake<touching<point_on_surface<Ball, Ground, Ground, l>>>()),
            "the surface of the contact between Ball and Ground does not depend on surface::x, surface::y or "
            "surface::z");
}

// Their rates would have to contain those of the shapes.
TEST(values_of_loads, shapes_that_change) {
  EXPECT_EQ((mistake<touching<sphere_on_plane<Ball, 0.1 + t, Ground, Ground::z>>>()),
            "the radius of the contact between Ball and Ground contains the time t; it may contain only "
            "parameters");
  EXPECT_EQ((mistake<touching<point_on_surface<Ball, Ground, Ground, surface::z - T>>>()),
            "the surface of the contact between Ball and Ground contains the input T; it may contain only "
            "parameters");
  using drum = around_cylinder<Ground, Ground, Ground::z, T, P, H, wrapping::clockwise>;
  EXPECT_EQ((mistake<linear_damper<drum, 1>>()),
            "the surface of the linear damper between P and H contains the input T; it may contain only "
            "parameters");
  EXPECT_EQ((mistake<linear_damper<given_length<q_of<Arm> - T>, 1>>()),
            "the length of the linear damper with q_Arm - T contains the input T, whose rate is not known; "
            "declare it prescribed and list its rates among the inputs");
  EXPECT_EQ((mistake<linear_spring<given_length<q_of<Arm> - T>, 1>>()), "");
  EXPECT_EQ((mistake<stop<Arm, -1, T, 100, 0.1>>()),
            "the greatest length of the stop with q_Arm contains the input T, whose rate is not known; "
            "declare it prescribed and list its rates among the inputs");
  EXPECT_EQ((mistake<stop<Arm, -1, T, 100, 0.0>>()), "");
}

TEST(values_of_loads, pathways_that_do_not_exist) {
  EXPECT_EQ((mistake<force_along<straight<P, P2>, T>>()),
            "the length of the force between P and P2 is the same in every configuration");
  EXPECT_EQ((mistake<force_along<through<P, P2, H>, T>>()), "");
  EXPECT_EQ((mistake<force_along<given_length<l>, T>>()),
            "the length of the force with l is the same in every configuration");
  using turn = around_cylinder<Ground, Ground, Ground::z, 0.1, P, P, wrapping::clockwise>;
  EXPECT_EQ((mistake<force_along<turn, T>>()), "a force acts between point P and itself");
  using wide = around_cylinder<Ground, Ground, Ground::z, 0.7, P, H, wrapping::clockwise>;
  EXPECT_EQ((mistake<force_along<wide, T>>()),
            "the end P of the force between P and H is inside the surface");
  using away = around_sphere<Ground, 0.1, on_surface<P>, H>;
  EXPECT_EQ((mistake<force_along<away, T>>()),
            "the end P of the force between P and H is not on the surface");
  using drum = around_cylinder<Arm, Arm, Arm::z, 0.5, on_surface<P>, H, wrapping::clockwise>;
  EXPECT_EQ((mistake<force_along<drum, T>>()), "");
  using flat = around_cone<Ground, Ground, Ground::x, 2.0, P, H, wrapping::clockwise>;
  EXPECT_EQ((mistake<force_along<flat, T>>()),
            "the angle between the axis of the force between P and H and its cone is not less than a right "
            "angle");
}

TEST(values_of_loads, that_are_listed_twice) {
  EXPECT_EQ((mistake<touching<on_floor>, touching<on_floor>>()),
            "the contact between Ball and Ground is listed twice");
  using mount = bushing<Arm, Ball, 1, 1, 1, 1, 1, 1>;
  EXPECT_EQ((mistake<mount, mount>()), "the bushing between Arm and Ball is listed twice");
  EXPECT_EQ((mistake<bushing<Arm, Ball, 1, 1, 1, -1, 1, 1>>()),
            "a stiffness of the bushing between Arm and Ball is negative");
}

using round_wheel = thin_wheel<Ball, Ball::y, 0.3>;
using flat = flat_ground<Ground, Ground::z>;
template <class... Words>
std::string mistake_of_tyre() {
  return mistake<tyre<round_wheel, flat, standstill<0.1>, Words...>>();
}

struct Fork : pin<Fork, Ground, axis<Ground::x>, mass> {};
struct Hub : pin<Hub, Fork, axis<own::y>, mass> {};
struct Skew : pin<Skew, Fork, axis<0.6 * own::y + l * own::z>, mass> {};
template <class Body, auto axis>
std::string mistake_of_torus() {
  using shape = torus_on_plane<Body, axis, 0.3, 0.1, Ground, Ground::z>;
  struct System
      : kane_system<inertial<Ground>, joints<Fork, Hub, Skew>, used_elsewhere<l>, loads<touching<shape>>> {};
  return derive<System>().mistake();
}

// The axis of a torus or a wheel may be given in any frame in which the body only turns about it.
TEST(values_of_loads, axes_that_turn_in_their_bodies) {
  EXPECT_EQ((mistake_of_torus<Hub, Fork::y>()), "");
  EXPECT_EQ((mistake_of_torus<Hub, Hub::y>()), "");
  EXPECT_EQ((mistake_of_torus<Skew, 0.6 * Fork::y + l * Fork::z>()), "");
  for (const std::string& found : {mistake_of_torus<Hub, Fork::z>(), mistake_of_torus<Hub, Ground::y>()})
    EXPECT_EQ(found, "the axis of the torus of the contact between Hub and Ground turns in Hub, the frame of "
                     "its body");
  EXPECT_EQ((mistake_of_tyre<linear_tyre<1, 1>>()), "");
  EXPECT_EQ((mistake<tyre<thin_wheel<Ball, Ground::y, 0.3>, flat, linear_tyre<1, 1>, standstill<0.1>>>()),
            "the axis of the tyre between Ball and Ground turns in Ball, the frame of its body");
}

TEST(values_of_loads, tyres_that_drive_or_do_nothing) {
  using grip = brush_tyre<0.8, 1000>;
  EXPECT_EQ((mistake_of_tyre<grip, wheel_load<-5>>()),
            "the load of the tyre between Ball and Ground is negative");
  EXPECT_EQ((mistake_of_tyre<grip, wheel_load<5>, effective_radius<-0.3>>()),
            "the effective radius of the tyre between Ball and Ground is not positive");
  EXPECT_EQ((mistake_of_tyre<brush_tyre<-0.8, 1000>, wheel_load<5>>()),
            "the coefficient of friction of the tyre between Ball and Ground is negative");
  EXPECT_EQ((mistake_of_tyre<brush_tyre<0.8, -1000>, wheel_load<5>>()),
            "the slip stiffness of the tyre between Ball and Ground is negative");
  EXPECT_EQ((mistake_of_tyre<grip, radial_stiffness<100, -1, 0.01>>()),
            "the radial damping of the tyre between Ball and Ground is negative");
  EXPECT_EQ((mistake_of_tyre<grip, wheel_load<5>, relaxation<-0.3, 0.3>>()),
            "a relaxation length of the tyre between Ball and Ground is not positive");
  EXPECT_EQ(
      (mistake<tyre<toroidal_wheel<Ball, Ball::y, 0.3, -0.1>, flat, linear_tyre<1, 1>, standstill<1>>>()),
      "the radius of the tube of the tyre between Ball and Ground is negative");
}

struct Slow : slew_limit<Slow, q_of<Arm>, -1.0, 0.1> {};
struct Valve : slew_limit<Valve, q_of<Arm>, 1.0, -0.1> {};
struct Active : muscle_activation<Active, q_of<Arm>, 0.01, -0.1> {};
struct Control : pid<Control, q_of<Arm>, 1, 2, 3, 0.1, -5, 5, -0.1> {};
inline constexpr muscle_parameters bent{
    .peak_isometric_force = 500.0, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2, .pennation = 1.6};
struct Bent : muscle<Bent, straight<P, H>, T, bent> {};
inline constexpr muscle_parameters halved{.peak_isometric_force = 500.0,
                                          .optimal_fiber_length = 0.1,
                                          .tendon_slack_length = 0.2,
                                          .pennation = 1 / 2};
struct Halved : muscle<Halved, straight<P, H>, T, halved> {};

template <class Block>
std::string mistake_of_block() {
  struct System : kane_system<inertial<Ground>, joints<Arm>, blocks<Block>> {};
  return derive<System>().mistake();
}

TEST(values_of_loads, constants_of_blocks_and_motors) {
  EXPECT_EQ(mistake_of_block<Slow>(), "the rate of block Slow is not positive");
  EXPECT_EQ(mistake_of_block<Valve>(), "the time constant of block Valve is not positive");
  EXPECT_EQ(mistake_of_block<Active>(), "the time of deactivation of block Active is not positive");
  EXPECT_EQ(mistake_of_block<Control>(),
            "the time constant of the integral part of block Control is not positive");
  EXPECT_EQ((mistake<dc_motor<Arm, T, -2.0, 0.1, 0.1>>()),
            "the resistance of the DC motor between Arm and Ground is not positive");
  EXPECT_EQ((mistake<dc_motor<Arm, T, 2.0, -0.1, 0.1>>()),
            "the inductance of the DC motor between Arm and Ground is not positive");
  EXPECT_EQ((mistake<Bent>()), "the pennation of the muscle Bent is not less than a right angle");
}

// Zero is written as 0.0, because 1/2 is the integer 0 in C++. Only lists of components may contain 0.
TEST(values_of_loads, integers_that_are_zero) {
  const auto sentence = [](std::string_view what) {
    return std::string(what) + " contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or "
                               "rational<1, 2>, or 0.0 if you mean zero";
  };
  EXPECT_EQ((mistake<stop<Arm, -1 / 2, 1, 100, 0.1>>()), sentence("the least length of the stop with q_Arm"));
  EXPECT_EQ((mistake<stop<Arm, -1, 1, 100, 1 / 2>>()), sentence("the damping of the stop with q_Arm"));
  EXPECT_EQ((mistake<stop<Arm, 0.0, 1, 100, 0.0>>()), "");
  EXPECT_EQ((mistake_of_tyre<brush_tyre<1, 1000>, radial_stiffness<100, 1 / 2, 0.01>>()),
            sentence("the radial damping of the tyre between Ball and Ground"));
  EXPECT_EQ((mistake<bushing<Arm, Ball, 1 / 2, 1 / 2, 1 / 2, 1 / 2, 1 / 2, 1 / 2>>()),
            sentence("a stiffness of the bushing between Arm and Ball"));
  EXPECT_EQ((mistake<bushing<Arm, Ball, 0, 0, 0, 1, 1, 1>>()), "");
  EXPECT_EQ((mistake<contact<on_floor, elastic<100, 3 / 2>, smoothed_over<0.001>>>()),
            "the contact between Ball and Ground has elastic<k, 1>; 1 is also the value of 3/2 in C++; write "
            "1.5, or omit the exponent 1");
  EXPECT_EQ((mistake<contact<on_floor, elastic<100, 2>, smoothed_over<0.001>>>()), "");
  EXPECT_EQ((mistake<Halved>()), sentence("the pennation of the muscle Halved"));
}

// In a model with units, the slip speed of a joint may be a number, as everywhere.
namespace of_joints {

constexpr parameter<"N", units::si::newton> N;
constexpr parameter<"r", units::si::meter> r;
constexpr parameter<"w", units::si::meter / units::si::second> w;

template <class... Loads>
std::string mistake() {
  struct System : kane_system<inertial<Ground>, joints<Arm>, used_elsewhere<N, r, w>, loads<Loads...>> {};
  return derive<System>().mistake();
}

TEST(values_of_loads, units_of_friction_in_joints) {
  EXPECT_EQ((mistake<friction<Arm, N * r, stribeck_friction<0.3, 0.2, 0.1, 0.01>>>()), "");
  EXPECT_EQ((mistake<friction<Arm, N * r, coulomb_friction<0.3, 0.1>>>()), "");
  EXPECT_EQ((mistake<friction<Arm, N * r, coulomb_friction<0.3, w>>>()),
            "the slip speed of the friction between Arm and Ground is w [m/s], but must be in rad/s");
  EXPECT_EQ(
      (mistake<friction<Arm, N, coulomb_friction<0.3, 0.1>>>()),
      "the dry part of the friction between Arm and Ground is 0.3*N [N], but must be in N m; the factor 0.3 "
      "has no unit");
}

} // namespace of_joints

} // namespace
