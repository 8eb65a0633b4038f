#pragma once

#include <kanexpr/blocks.hpp>
#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/tyres.hpp>

/// A wheel with a tyre after the Magic Formula on uneven ground, which carries a leg: a motor with a
/// controller drives the wheel, a muscle with an elastic tendon moves the leg, and bristles hold its foot.
namespace driven_wheel {

using namespace kanexpr;

constexpr parameter<"k"> k;
constexpr parameter<"mu"> mu;
constexpr parameter<"F"> F;
constexpr parameter<"s"> s; // relaxation length
constexpr input<"w"> w;     // the wanted speed
constexpr input<"e"> e;     // the excitation of the muscle

struct N : inertial_ground<N> {}; // z points up
struct Forward : prismatic<Forward, N, axis<N::x>> {};
struct Left : prismatic<Left, Forward, axis<Forward::y>> {};
struct Frame : prismatic<Frame, Left, axis<Left::z>, body<3.0, 0.0 * own::x>> {};
struct Wheel : pin<Wheel, Frame, axis<0.1 * Frame::x + Frame::y + 0.05 * Frame::z>,
                   body<2.0, 0.0 * own::x, inertia<own, 0.06, 0.1, 0.06>>> {};
struct Leg : pin<Leg, Frame, axis<Frame::y>, at<0.1 * Frame::z>,
                 body<1.5, -0.2 * own::z, inertia<own, 0.03, 0.03, 0.01>>> {};
struct Foot : offset<Foot, Leg, -0.45 * Leg::z> {};
struct Hip : offset<Hip, Frame, 0.3 * Frame::z> {};
struct Knee : offset<Knee, Leg, 0.04 * Leg::x> {};

constexpr auto height = 0.05 * cos(1.3 * surface::x) * sin(0.7 * surface::y);

inline constexpr tyre_coefficients coefficients{.Fz0 = 80,
                                                .R0 = 0.31,
                                                .pCx1 = 1.6,
                                                .pDx1 = mu,
                                                .pEx1 = 0.3,
                                                .pKx1 = 21,
                                                .rBx1 = 12,
                                                .rCx1 = 1.1,
                                                .pCy1 = 1.3,
                                                .pDy1 = mu,
                                                .pEy1 = -1,
                                                .pKy1 = -15,
                                                .pKy2 = 1.6,
                                                .pKy4 = 2,
                                                .rBy1 = 8,
                                                .rCy1 = 1.1,
                                                .qBz1 = 9,
                                                .qBz9 = 15,
                                                .qCz1 = 1.2,
                                                .qDz1 = 0.1,
                                                .qEz1 = -1.5};
using Tyre =
    tyre<thin_wheel<Wheel, 0.1 * Frame::x + Frame::y + 0.05 * Frame::z, 0.3>, uneven_ground<N, N, height, 1>,
         magic_formula<coefficients>, radial_stiffness<k, 0.1, 0.01>, relaxation<s, 2 * s>, standstill<0.5>>;
using Step = contact<point_on_surface<Foot, N, N, surface::z - 0.3 - height>, elastic<k>, smoothed_over<0.02>,
                     dissipation<0.3>, lugre_friction<0.8, 0.6, 0.3, 30.0, 0.5, 0.02>>;

struct Smooth : lag<Smooth, w, 0.1> {};
struct Late : delay<Late, 2, Smooth::output, 0.05> {};
struct Controller : pid<Controller, Late::output - u_of<Wheel>, 2.0, 1.0, 0.02, 0.01, -24.0, 24.0, 0.2> {};
struct Pull : muscle<Pull, straight<Hip, Knee>, e,
                     muscle_parameters{.peak_isometric_force = F,
                                       .optimal_fiber_length = 0.1,
                                       .tendon_slack_length = 0.1,
                                       .pennation = 0.1,
                                       .formulation = muscle_formulation::tendon_force}> {};

struct System : kane_system<inertial<N>, joints<Forward, Left, Frame, Wheel, Leg>, parameters<k, mu, F, s>,
                            inputs<w, e>, blocks<Smooth, Late, Controller>,
                            loads<gravity<-9.81 * N::z>, Tyre, Step, Pull,
                                  dc_motor<Wheel, Controller::output, 1.5, 0.01, 0.05, 10, 1e-4, 1e-4>,
                                  friction<Forward, 2, dahl_friction<mu, 30.0, 0.1>>>> {};

} // namespace driven_wheel
