#pragma once

#include <kanexpr/kanexpr.hpp>

/// The Whipple bicycle: a frame with a rigid rider, a fork and two wheels that roll without slipping.
/// Meijaard, Papadopoulos, Ruina & Schwab (2007); lengths and inertias as in SymPy's test of Kane's method.
namespace bicycle {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", radian> q1; // yaw
constexpr coordinate<"q2", radian> q2; // lean
constexpr coordinate<"q4", radian> q4; // pitch
constexpr coordinate<"q5", radian> q5; // steer
constexpr speed<"u1", radian / second> u1;
constexpr speed<"u2", radian / second> u2;
constexpr speed<"u3", radian / second> u3; // spin of the rear wheel
constexpr speed<"u4", radian / second> u4;
constexpr speed<"u5", radian / second> u5;
constexpr speed<"u6", radian / second> u6; // spin of the front wheel

constexpr parameter<"WFrad", meter> WFrad;
constexpr parameter<"WRrad", meter> WRrad;
constexpr parameter<"htangle", radian> htangle; // angle between the head tube and the ground
constexpr parameter<"forkoffset", meter> forkoffset;
constexpr parameter<"forklength", meter> forklength;
constexpr parameter<"framelength", meter> framelength;
constexpr parameter<"forkcg1", meter> forkcg1;
constexpr parameter<"forkcg3", meter> forkcg3;
constexpr parameter<"framecg1", meter> framecg1;
constexpr parameter<"framecg3", meter> framecg3;
constexpr parameter<"Iwr11", kilogram * pow<2>(meter)> Iwr11;
constexpr parameter<"Iwr22", kilogram * pow<2>(meter)> Iwr22;
constexpr parameter<"Iwf11", kilogram * pow<2>(meter)> Iwf11;
constexpr parameter<"Iwf22", kilogram * pow<2>(meter)> Iwf22;
constexpr parameter<"Ifork11", kilogram * pow<2>(meter)> Ifork11;
constexpr parameter<"Ifork22", kilogram * pow<2>(meter)> Ifork22;
constexpr parameter<"Ifork33", kilogram * pow<2>(meter)> Ifork33;
constexpr parameter<"Ifork31", kilogram * pow<2>(meter)> Ifork31;
constexpr parameter<"Iframe11", kilogram * pow<2>(meter)> Iframe11;
constexpr parameter<"Iframe22", kilogram * pow<2>(meter)> Iframe22;
constexpr parameter<"Iframe33", kilogram * pow<2>(meter)> Iframe33;
constexpr parameter<"Iframe31", kilogram * pow<2>(meter)> Iframe31;
constexpr parameter<"mfork", kilogram> mfork;
constexpr parameter<"mframe", kilogram> mframe;
constexpr parameter<"mwf", kilogram> mwf;
constexpr parameter<"mwr", kilogram> mwr;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // z points up
struct Y : rotated<Y, N, q1, N::z> {};
struct R : rotated<R, Y, q2, Y::x> {};
struct Frame : rotated<Frame, R, q4 + htangle, R::y> {}; // x along the steering axis, down
struct Fork : rotated<Fork, Frame, q5, Frame::x> {};
struct WR : rotated<WR, Frame, 0, Frame::y>, angular_velocity<Frame, u3 * Frame::y> {};
struct WF : rotated<WF, Fork, 0, Fork::y>, angular_velocity<Fork, u6 * Fork::y> {};

// Axes that are level when the bicycle is upright, for the inertias.
struct LevelFrame : rotated<LevelFrame, Frame, -htangle, Frame::y> {};
struct LevelFork : rotated<LevelFork, Fork, -htangle, Fork::y> {};

// From the center of the front wheel to its lowest point.
constexpr auto down_front = normalized(dot(Fork::y, Y::z) * Fork::y - Y::z);

struct WR_cont : origin<WR_cont, N> {}; // contact: no velocity in N
struct WR_mc : offset<WR_mc, WR_cont, WRrad * R::z>, fixed_in<WR> {};
struct Steer : offset<Steer, WR_mc, framelength * Frame::z> {};
struct Frame_mc : offset<Frame_mc, WR_mc, -framecg1 * Frame::x + framecg3 * Frame::z> {};
struct Fork_mc : offset<Fork_mc, Steer, -forkcg1 * Fork::x + forkcg3 * Fork::z> {};
struct WF_mc : offset<WF_mc, Steer, forklength * Fork::x + forkoffset * Fork::z> {};
struct WF_cont : offset<WF_cont, WF_mc, WFrad * down_front>, fixed_in<WF> {};

struct BodyFrame : rigid_body<BodyFrame, Frame_mc, Frame, mframe,
                              inertia<LevelFrame, Iframe11, Iframe22, Iframe33, 0, 0, Iframe31>> {};
struct BodyFork : rigid_body<BodyFork, Fork_mc, Fork, mfork,
                             inertia<LevelFork, Ifork11, Ifork22, Ifork33, 0, 0, Ifork31>> {};
struct BodyWR : rigid_body<BodyWR, WR_mc, WR, mwr, inertia<Frame, Iwr11, Iwr22, Iwr11>> {};
struct BodyWF : rigid_body<BodyWF, WF_mc, WF, mwf, inertia<Fork, Iwf11, Iwf22, Iwf11>> {};

template <class... More>
struct whipple : kane_system<inertial<N>, coordinates<q1, q2, q5, q4>, speeds<u2, u3, u5, u1, u4, u6>,
                             kinematics<dot(q1) == u1, dot(q2) == u2, dot(q4) == u4, dot(q5) == u5>,
                             configuration_constraints<dot(position_of<WF_cont, WR_cont>, Y::z) == 0>,
                             velocity_constraints<zero_along<velocity_of<WF_cont>, Y::x, Y::y, Y::z>>,
                             dependent<u1, u4, u6, q4>, bodies<BodyFrame, BodyFork, BodyWR, BodyWF>,
                             loads<gravity<-g * N::z>>, More...> {};

struct System : whipple<> {};

/// The parameters of the benchmark bicycle.
using benchmark_values =
    values<WFrad == 0.35, WRrad == 0.3, htangle == 1.2566370614359172, forkoffset == 0.03207142672761931,
           forklength == 0.26764450844768867, framelength == 0.9534570696121847,
           forkcg1 == 0.10230731158060875, forkcg3 == 0.026100592803432483, framecg1 == 0.4779288114646079,
           framecg3 == 0.4707271515135145, Iwr11 == 0.0603, Iwr22 == 0.12, Iwf11 == 0.1405, Iwf22 == 0.28,
           Ifork11 == 0.05892, Ifork22 == 0.06, Ifork33 == 0.00708, Ifork31 == 0.00756, Iframe11 == 9.2,
           Iframe22 == 11, Iframe33 == 2.8, Iframe31 == -2.4, mfork == 4, mframe == 85, mwf == 3, mwr == 2,
           g == 9.81>;

/// The benchmark bicycle.
struct BoundSystem : whipple<benchmark_values> {};

/// The same with a torque between fork and frame, with which the rider steers.
constexpr input<"T", newton * meter> T;
struct SteeredSystem : extended<BoundSystem, inputs<T>, loads<torque_between<Fork, Frame, T * Frame::x>>> {};

} // namespace bicycle
