#include <kanexpr/symbolic.hpp>
#include <kanexpr/joints.hpp>
#include <cstdio>
#include <iostream>
#include <utility>
#line 1 "/work/h_planted/examples/models/andrews.hpp"
namespace andrews {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"beta", radian> be;
constexpr coordinate<"Theta", radian> th;
constexpr coordinate<"gamma", radian> ga;
constexpr coordinate<"Phi", radian> ph;
constexpr coordinate<"delta", radian> de;
constexpr coordinate<"Omega", radian> om;
constexpr coordinate<"epsilon", radian> ep;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"u4"> u4;
constexpr speed<"u5"> u5;
constexpr speed<"u6"> u6;
constexpr speed<"u7"> u7;

// Lengths in meters, with the names used in the books.
constexpr double d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007, ra = 0.00092, ss = 0.035,
                 sa = 0.01874, sb = 0.01043, ta = 0.02308, tb = 0.00916, u = 0.04, ua = 0.01228, ub = 0.00449,
                 zf = 0.02, zt = 0.04, fa = 0.01421;
constexpr double mom = 0.033; // torque of the motor, N m

// The force of the spring combines quantities with several units.
constexpr auto c0 = constant<4530, newton / meter>;
constexpr auto l0 = constant<0.07785, meter>, sc = constant<0.018, meter>, sd = constant<0.02, meter>;

struct N : inertial_frame<N> {};
struct K1 : rotated<K1, N, be, N::z> {};
struct K2 : rotated<K2, K1, th, K1::z> {};
struct K3 : rotated<K3, N, ga, N::z> {};
struct K5 : rotated<K5, N, de, N::z> {};
struct K4 : rotated<K4, K5, ph, K5::z> {};
struct K7 : rotated<K7, N, ep, N::z> {};
struct K6 : rotated<K6, K7, om, K7::z> {};

// Bearings on the ground.
struct O : origin<O, N> {};
struct A : offset<A, O, -0.06934 * N::x - 0.00227 * N::y> {};
struct B : offset<B, O, -0.03635 * N::x + 0.03273 * N::y> {};

// Three bodies are attached to the rod K2 at the joint E.
struct F : offset<F, O, rr * K1::x> {};
struct E : offset<E, F, -d * K2::x> {};
struct E3 : offset<E3, B, -ss * K3::y> {};
struct G : offset<G, A, zt * K5::x> {};
struct E4 : offset<E4, G, -e * K4::y> {};
struct H : offset<H, A, -u * K7::y> {};
struct E6 : offset<E6, H, zf * K6::x> {};

// A spring from the ground to a point of K3.
constexpr auto arm = sd * K3::x - sc * K3::y;
constexpr auto spring = arm - constant<0.05035, meter> * N::x - constant<0.03927, meter> * N::y;
struct D : offset<D, B, arm> {};

struct C1 : offset<C1, O, ra * K1::x> {};
struct C2 : offset<C2, F, -da * K2::x> {};
struct C3 : offset<C3, B, sb * K3::x - sa * K3::y> {};
struct C4 : offset<C4, G, -(e - ea) * K4::y> {};
struct C5 : offset<C5, A, ta * K5::x - tb * K5::y> {};
struct C6 : offset<C6, H, (zf - fa) * K6::x> {};
struct C7 : offset<C7, A, ub * K7::x - ua * K7::y> {};

struct Body1 : rigid_body<Body1, C1, K1, 0.04325, inertia<K1, 0, 0, 2.194e-6>> {};
struct Body2 : rigid_body<Body2, C2, K2, 0.00365, inertia<K2, 0, 0, 4.410e-7>> {};
struct Body3 : rigid_body<Body3, C3, K3, 0.02373, inertia<K3, 0, 0, 5.255e-6>> {};
struct Body4 : rigid_body<Body4, C4, K4, 0.00706, inertia<K4, 0, 0, 5.667e-7>> {};
struct Body5 : rigid_body<Body5, C5, K5, 0.07050, inertia<K5, 0, 0, 1.169e-5>> {};
struct Body6 : rigid_body<Body6, C6, K6, 0.00706, inertia<K6, 0, 0, 5.667e-7>> {};
struct Body7 : rigid_body<Body7, C7, K7, 0.05498, inertia<K7, 0, 0, 1.912e-5>> {};

struct System
    : kane_system<
          inertial<N>, coordinates<be, th, ga, ph, de, om, ep>, speeds<u1, u2, u3, u4, u5, u6, u7>,
          kinematics<dot(be) == u1, dot(th) == u2, dot(ga) == u3, dot(ph) == u4, dot(de) == u5, dot(om) == u6,
                     dot(ep) == u7>,
          configuration_constraints<zero_along<position_of<E, E3>, N::x, N::y>,
                                    zero_along<position_of<E, E4>, N::x, N::y>,
                                    zero_along<position_of<E, E6>, N::x, N::y>>,
          bodies<Body1, Body2, Body3, Body4, Body5, Body6, Body7>,
          loads<torque<K1, mom * N::z>, force<D, -c0*(magnitude(spring) - l0) * normalized(spring)>>> {};

} // namespace andrews

#line 1 "/work/h_planted/examples/models/arm3.hpp"
namespace arm3 {

using namespace kanexpr;
using namespace kanexpr::units;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr input<"T", i, newton * meter> T;

template <int i>
constexpr parameter<"m", i, kilogram> m;
template <int i>
constexpr parameter<"cx", i, meter> cx; // from the joint to the mass center
template <int i>
constexpr parameter<"cy", i, meter> cy;
template <int i>
constexpr parameter<"cz", i, meter> cz;
template <int i>
constexpr parameter<"Ixx", i, kilogram * pow<2>(meter)> Ixx;
template <int i>
constexpr parameter<"Iyy", i, kilogram * pow<2>(meter)> Iyy;
template <int i>
constexpr parameter<"Izz", i, kilogram * pow<2>(meter)> Izz;
template <int i>
constexpr parameter<"Ixy", i, kilogram * pow<2>(meter)> Ixy;
template <int i>
constexpr parameter<"Iyz", i, kilogram * pow<2>(meter)> Iyz;
template <int i>
constexpr parameter<"Izx", i, kilogram * pow<2>(meter)> Izx;
template <int i>
constexpr parameter<"lx", i, meter> lx; // from the joint to the next one
template <int i>
constexpr parameter<"ly", i, meter> ly;
template <int i>
constexpr parameter<"lz", i, meter> lz;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // z points up
struct B1 : rotated<B1, N, q<1>, N::z> {};
struct B2 : rotated<B2, B1, q<2>, B1::y> {};
struct B3 : rotated<B3, B2, q<3>, B2::x> {};

struct J1 : origin<J1, N> {};
struct J2 : offset<J2, J1, lx<1> * B1::x + ly<1> * B1::y + lz<1> * B1::z> {};
struct J3 : offset<J3, J2, lx<2> * B2::x + ly<2> * B2::y + lz<2> * B2::z> {};

/// Link number i, which rotates with `B` about the joint `J`.
template <int i, class J, class B>
struct Center : offset<Center<i, J, B>, J, cx<i> * B::x + cy<i> * B::y + cz<i> * B::z> {};
template <int i, class J, class B>
struct Link : rigid_body<Link<i, J, B>, Center<i, J, B>, B, m<i>,
                         inertia<B, Ixx<i>, Iyy<i>, Izz<i>, Ixy<i>, Iyz<i>, Izx<i>>> {};

// Each motor acts on its link and, with the opposite torque, on the previous one.
constexpr auto motor1 = T<1> * N::z;
constexpr auto motor2 = T<2> * B1::y;
constexpr auto motor3 = T<3> * B2::x;

struct System
    : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>>, speeds<u<1>, u<2>, u<3>>,
                  kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>>,
                  parameters<g, m<1>, cx<1>, cy<1>, cz<1>, Ixx<1>, Iyy<1>, Izz<1>, Ixy<1>, Iyz<1>, Izx<1>,
                             lx<1>, ly<1>, lz<1>, m<2>, cx<2>, cy<2>, cz<2>, Ixx<2>, Iyy<2>, Izz<2>, Ixy<2>,
                             Iyz<2>, Izx<2>, lx<2>, ly<2>, lz<2>, m<3>, cx<3>, cy<3>, cz<3>, Ixx<3>, Iyy<3>,
                             Izz<3>, Ixy<3>, Iyz<3>, Izx<3>>,
                  inputs<T<1>, T<2>, T<3>>, bodies<Link<1, J1, B1>, Link<2, J2, B2>, Link<3, J3, B3>>,
                  loads<gravity<-g * N::z>, torque<B1, motor1>, torque<B2, motor2>, torque<B1, -motor2>,
                        torque<B3, motor3>, torque<B2, -motor3>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q<1>, q<2>, q<3>>,
                      parameters<g, m<1>, cx<1>, cy<1>, cz<1>, Ixx<1>, Iyy<1>, Izz<1>, Ixy<1>, Iyz<1>, Izx<1>,
                                 lx<1>, ly<1>, lz<1>, m<2>, cx<2>, cy<2>, cz<2>, Ixx<2>, Iyy<2>, Izz<2>,
                                 Ixy<2>, Iyz<2>, Izx<2>, lx<2>, ly<2>, lz<2>, m<3>, cx<3>, cy<3>, cz<3>,
                                 Ixx<3>, Iyy<3>, Izz<3>, Ixy<3>, Iyz<3>, Izx<3>>,
                      inputs<T<1>, T<2>, T<3>>, bodies<Link<1, J1, B1>, Link<2, J2, B2>, Link<3, J3, B3>>,
                      loads<gravity<-g * N::z>, torque<B1, motor1>, torque<B2, motor2>, torque<B1, -motor2>,
                            torque<B3, motor3>, torque<B2, -motor3>>> {};

} // namespace arm3

#line 1 "/work/h_planted/examples/models/arm6.hpp"
namespace arm6 {

using namespace kanexpr;
using namespace kanexpr::units;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr input<"T", i, newton * meter> T;
constexpr parameter<"g", meter / pow<2>(second)> g;

template <int i>
constexpr parameter<"m", i, kilogram> m;
template <int i>
constexpr parameter<"x", i, meter> x; // of the mass center, in the link's axes
template <int i>
constexpr parameter<"y", i, meter> y;
template <int i>
constexpr parameter<"z", i, meter> z;
template <int i>
constexpr parameter<"Ixx", i, kilogram * pow<2>(meter)> Ixx;
template <int i>
constexpr parameter<"Iyy", i, kilogram * pow<2>(meter)> Iyy;
template <int i>
constexpr parameter<"Izz", i, kilogram * pow<2>(meter)> Izz;
template <int i>
constexpr parameter<"Ixy", i, kilogram * pow<2>(meter)> Ixy;
template <int i>
constexpr parameter<"Iyz", i, kilogram * pow<2>(meter)> Iyz;
template <int i>
constexpr parameter<"Izx", i, kilogram * pow<2>(meter)> Izx;
template <int i>
constexpr parameter<"a", i, meter> a; // of the next joint, in the link's axes
template <int i>
constexpr parameter<"b", i, meter> b;
template <int i>
constexpr parameter<"d", i, meter> d;

struct N : inertial_frame<N> {}; // z points up
struct O : origin<O, N> {};

template <int i>
struct Link;
template <>
struct Link<1> : rotated<Link<1>, N, q<1>, N::z> {};
template <>
struct Link<2> : rotated<Link<2>, Link<1>, q<2>, Link<1>::y> {};
template <>
struct Link<3> : rotated<Link<3>, Link<2>, q<3>, Link<2>::y> {};
template <>
struct Link<4> : rotated<Link<4>, Link<3>, q<4>, Link<3>::x> {};
template <>
struct Link<5> : rotated<Link<5>, Link<4>, q<5>, Link<4>::y> {};
template <>
struct Link<6> : rotated<Link<6>, Link<5>, q<6>, Link<5>::x> {};

/// Joint i, about which link i rotates.
template <int i>
struct Joint : offset<Joint<i>, Joint<i - 1>,
                      a<i - 1> * Link<i - 1>::x + b<i - 1> * Link<i - 1>::y + d<i - 1> * Link<i - 1>::z> {};
template <>
struct Joint<1> : offset<Joint<1>, O, 0.0 * N::x> {};

template <int i>
struct Center : offset<Center<i>, Joint<i>, x<i> * Link<i>::x + y<i> * Link<i>::y + z<i> * Link<i>::z> {};
template <int i>
struct Body : rigid_body<Body<i>, Center<i>, Link<i>, m<i>,
                         inertia<Link<i>, Ixx<i>, Iyy<i>, Izz<i>, Ixy<i>, Iyz<i>, Izx<i>>> {};

struct System : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>, q<4>, q<5>, q<6>>,
                            speeds<u<1>, u<2>, u<3>, u<4>, u<5>, u<6>>,
                            kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>,
                                       dot(q<4>) == u<4>, dot(q<5>) == u<5>, dot(q<6>) == u<6>>,
                            inputs<T<1>, T<2>, T<3>, T<4>, T<5>, T<6>>,
                            bodies<Body<1>, Body<2>, Body<3>, Body<4>, Body<5>, Body<6>>,
                            loads<gravity<-g * N::z>, torque<Link<1>, T<1> * N::z>,
                                  torque<Link<2>, T<2> * Link<1>::y>, torque<Link<1>, -T<2> * Link<1>::y>,
                                  torque<Link<3>, T<3> * Link<2>::y>, torque<Link<2>, -T<3> * Link<2>::y>,
                                  torque<Link<4>, T<4> * Link<3>::x>, torque<Link<3>, -T<4> * Link<3>::x>,
                                  torque<Link<5>, T<5> * Link<4>::y>, torque<Link<4>, -T<5> * Link<4>::y>,
                                  torque<Link<6>, T<6> * Link<5>::x>, torque<Link<5>, -T<6> * Link<5>::x>>> {
};

} // namespace arm6

#line 1 "/work/h_planted/examples/models/bicycle.hpp"
namespace bicycle {

using namespace kanexpr;
using namespace kanexpr::units;

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

/// The benchmark bicycle.
struct BoundSystem
    : whipple<values<WFrad == 0.35, WRrad == 0.3, htangle == 1.2566370614359172,
                     forkoffset == 0.03207142672761931, forklength == 0.26764450844768867,
                     framelength == 0.9534570696121847, forkcg1 == 0.10230731158060875,
                     forkcg3 == 0.026100592803432483, framecg1 == 0.4779288114646079,
                     framecg3 == 0.4707271515135145, Iwr11 == 0.0603, Iwr22 == 0.12, Iwf11 == 0.1405,
                     Iwf22 == 0.28, Ifork11 == 0.05892, Ifork22 == 0.06, Ifork33 == 0.00708,
                     Ifork31 == 0.00756, Iframe11 == 9.2, Iframe22 == 11, Iframe33 == 2.8, Iframe31 == -2.4,
                     mfork == 4, mframe == 85, mwf == 3, mwr == 2, g == 9.81>> {};

/// The same with a torque between fork and frame, with which the rider steers.
constexpr input<"T", newton * meter> T;
struct SteeredSystem : extended<BoundSystem, inputs<T>, loads<torque_between<Fork, Frame, T * Frame::x>>> {};

} // namespace bicycle

#line 1 "/work/h_planted/examples/models/chaplygin_sleigh.hpp"
namespace chaplygin_sleigh {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", meter> q1;
constexpr coordinate<"q2", meter> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"a", meter> a; // from the blade to the mass center
constexpr input<"F", newton> F;
constexpr input<"T", newton * meter> T;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q3, N::z> {};

constexpr auto v = u1 * A::x + u2 * A::y; // of the blade

struct O : origin<O, N> {};
struct P : offset<P, O, q1 * N::x + q2 * N::y>, velocity<N, v> {};
struct G : offset<G, P, a * A::x> {};

struct Sleigh : rigid_body<Sleigh, G, A, m, inertia<A, 0, 0, I>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u3, u2>,
                            kinematics<dot(q1) == dot(v, N::x), dot(q2) == dot(v, N::y), dot(q3) == u3>,
                            velocity_constraints<u2 == 0>, dependent<u2>, inputs<F, T>, bodies<Sleigh>,
                            loads<force<P, F * A::x>, torque<A, T * N::z>>> {};

/// The same sleigh, with the rates of the coordinates as speeds.
namespace by_rates {

struct P : offset<P, O, q1 * N::x + q2 * N::y> {};
struct G : offset<G, P, a * A::x> {};

struct Sleigh : rigid_body<Sleigh, G, A, m, inertia<A, 0, 0, I>> {};

} // namespace by_rates

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q1, q2, q3>,
                      velocity_constraints<zero_along<velocity_of<by_rates::P>, A::y>>, inputs<F, T>,
                      bodies<by_rates::Sleigh>, loads<force<by_rates::P, F * A::x>, torque<A, T * N::z>>> {};

} // namespace chaplygin_sleigh

#line 1 "/work/h_planted/examples/models/double_pendulum.hpp"
namespace double_pendulum {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"m1", kilogram> m1;
constexpr parameter<"m2", kilogram> m2;
constexpr parameter<"d1", meter> d1; // from a bar's joint to its mass center
constexpr parameter<"d2", meter> d2;
constexpr parameter<"l1", meter> l1;
constexpr parameter<"I1", kilogram * pow<2>(meter)> I1;
constexpr parameter<"I2", kilogram * pow<2>(meter)> I2;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"c1", newton * meter * second / radian> c1;
constexpr parameter<"c2", newton * meter * second / radian> c2;
constexpr input<"T1", newton * meter> T1;
constexpr input<"T2", newton * meter> T2;

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, q1, N::z>, angular_velocity<N, u1 * N::z> {};
struct B : rotated<B, A, q2, A::z>, angular_velocity<N, u2 * N::z> {};

struct O : origin<O, N> {}; // shoulder
struct G1 : offset<G1, O, d1 * A::x> {};
struct J : offset<J, O, l1 * A::x> {}; // elbow
struct G2 : offset<G2, J, d2 * B::x> {};

struct Bar1 : rigid_body<Bar1, G1, A, m1, inertia<A, 0, 0, I1>> {};
struct Bar2 : rigid_body<Bar2, G2, B, m2, inertia<B, 0, 0, I2>> {};

constexpr auto at_shoulder = (T1 - c1 * u1) * N::z;
constexpr auto at_elbow = (T2 - c2 * (u2 - u1)) * N::z;

struct System
    : kane_system<
          inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, kinematics<dot(q1) == u1, dot(q2) == u2 - u1>,
          parameters<m1, m2, d1, d2, l1, I1, I2, g, c1, c2>, inputs<T1, T2>, bodies<Bar1, Bar2>,
          loads<gravity<-g * N::y>, torque<A, at_shoulder>, torque<A, -at_elbow>, torque<B, at_elbow>>> {};

/// The same bars, with the rates of the angles as speeds.
namespace by_rates {

struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::z> {};

struct G1 : offset<G1, O, d1 * A::x> {};
struct J : offset<J, O, l1 * A::x> {};
struct G2 : offset<G2, J, d2 * B::x> {};

struct Bar1 : rigid_body<Bar1, G1, A, m1, inertia<A, 0, 0, I1>> {};
struct Bar2 : rigid_body<Bar2, G2, B, m2, inertia<B, 0, 0, I2>> {};

constexpr auto at_shoulder = (T1 - c1 * dot(q1)) * N::z;
constexpr auto at_elbow = (T2 - c2 * dot(q2)) * N::z;

} // namespace by_rates

struct LagrangeSystem
    : lagrange_system<
          inertial<N>, coordinates<q1, q2>, parameters<m1, m2, d1, d2, l1, I1, I2, g, c1, c2>, inputs<T1, T2>,
          bodies<by_rates::Bar1, by_rates::Bar2>,
          loads<gravity<-g * N::y>, torque<by_rates::A, by_rates::at_shoulder>,
                torque<by_rates::A, -by_rates::at_elbow>, torque<by_rates::B, by_rates::at_elbow>>> {};

} // namespace double_pendulum

#line 1 "/work/h_planted/examples/models/four_bar.hpp"
namespace four_bar {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"l0", meter> l0;
constexpr parameter<"l1", meter> l1;
constexpr parameter<"l2", meter> l2;
constexpr parameter<"l3", meter> l3;
constexpr parameter<"d1", meter> d1; // from a bar's joint to its mass center
constexpr parameter<"d2", meter> d2;
constexpr parameter<"d3", meter> d3;
constexpr parameter<"m1", kilogram> m1;
constexpr parameter<"m2", kilogram> m2;
constexpr parameter<"m3", kilogram> m3;
constexpr parameter<"I1", kilogram * pow<2>(meter)> I1;
constexpr parameter<"I2", kilogram * pow<2>(meter)> I2;
constexpr parameter<"I3", kilogram * pow<2>(meter)> I3;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr input<"T", newton * meter> T;

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::z> {};
struct C : rotated<C, B, q3, B::z> {};

struct O : origin<O, N> {};
struct P1 : offset<P1, O, l1 * A::x> {};
struct P2 : offset<P2, P1, l2 * B::x> {};
struct P3 : offset<P3, P2, l3 * C::x> {};
struct Bearing : offset<Bearing, O, l0 * N::x> {}; // bearing of the rocker on the ground

struct G1 : offset<G1, O, d1 * A::x> {};
struct G2 : offset<G2, P1, d2 * B::x> {};
struct G3 : offset<G3, P2, d3 * C::x> {};

struct Crank : rigid_body<Crank, G1, A, m1, inertia<A, 0, 0, I1>> {};
struct Coupler : rigid_body<Coupler, G2, B, m2, inertia<B, 0, 0, I2>> {};
struct Rocker : rigid_body<Rocker, G3, C, m3, inertia<C, 0, 0, I3>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                            kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3>,
                            configuration_constraints<zero_along<position_of<P3, Bearing>, N::x, N::y>>,
                            dependent<q2, q3, u2, u3>, inputs<T>, bodies<Crank, Coupler, Rocker>,
                            loads<gravity<-g * N::y>, torque<A, T * N::z>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q1, q2, q3>,
                      configuration_constraints<zero_along<position_of<P3, Bearing>, N::x, N::y>>,
                      dependent<q2, q3, dot(q2), dot(q3)>, inputs<T>, bodies<Crank, Coupler, Rocker>,
                      loads<gravity<-g * N::y>, torque<A, T * N::z>>> {};

} // namespace four_bar

#line 1 "/work/h_planted/examples/models/iiwa.hpp"
namespace iiwa {

using namespace kanexpr;
using namespace kanexpr::units;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr input<"T", i, newton * meter> T;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};

struct Link1 : rotated<Link1, N, q<1>, N::z> {};
struct Link1_joint : offset<Link1_joint, O, 0.1575 * N::z> {};
struct Link1_center : offset<Link1_center, Link1_joint, -0.03 * Link1::y + 0.12 * Link1::z> {};
struct Link1_body
    : rigid_body<Link1_body, Link1_center, Link1, 4, inertia<Link1, 0.1, 0.09000000000000001, 0.02>> {};

struct Link2_home : direction_cosines<Link2_home, Link1, -1, 0, 0, 0, 0, 1, 0, 1, 0> {};
struct Link2 : rotated<Link2, Link2_home, q<2>, Link2_home::z> {};
struct Link2_joint : offset<Link2_joint, Link1_joint, 0.2025 * Link1::z> {};
struct Link2_center
    : offset<Link2_center, Link2_joint, 0.0003 * Link2::x + 0.059 * Link2::y + 0.042 * Link2::z> {};
struct Link2_body : rigid_body<Link2_body, Link2_center, Link2, 4,
                               inertia<Link2, 0.050019999999999995, 0.01794364, 0.04397564,
                                       7.079999999999999e-05, 0.009912, 5.04e-05>> {};

struct Link3_home : direction_cosines<Link3_home, Link2, -1, 0, 0, 0, 0, 1, 0, 1, 0> {};
struct Link3 : rotated<Link3, Link3_home, q<3>, Link3_home::z> {};
struct Link3_joint : offset<Link3_joint, Link2_joint, 0.2045 * Link2::y> {};
struct Link3_center : offset<Link3_center, Link3_joint, 0.03 * Link3::y + 0.13 * Link3::z> {};
struct Link3_body : rigid_body<Link3_body, Link3_center, Link3, 3,
                               inertia<Link3, 0.07999999999999999, 0.07500000000000001, 0.01>> {};

struct Link4_home : direction_cosines<Link4_home, Link3, 1, 0, 0, 0, 0, -1, 0, 1, 0> {};
struct Link4 : rotated<Link4, Link4_home, q<4>, Link4_home::z> {};
struct Link4_joint : offset<Link4_joint, Link3_joint, 0.2155 * Link3::z> {};
struct Link4_center : offset<Link4_center, Link4_joint, 0.067 * Link4::y + 0.034 * Link4::z> {};
struct Link4_body
    : rigid_body<
          Link4_body, Link4_center, Link4, 2.7,
          inertia<Link4, 0.029958499999999992, 0.0099788, 0.028979699999999997, 0, 5.060000000000047e-05>> {};

struct Link5_home : direction_cosines<Link5_home, Link4, -1, 0, 0, 0, 0, 1, 0, 1, 0> {};
struct Link5 : rotated<Link5, Link5_home, q<5>, Link5_home::z> {};
struct Link5_joint : offset<Link5_joint, Link4_joint, 0.1845 * Link4::y> {};
struct Link5_center : offset<Link5_center, Link5_joint,
                             0.0001 * Link5::x + 0.021 * Link5::y + 0.07599999999999998 * Link5::z> {};
struct Link5_body
    : rigid_body<Link5_body, Link5_center, Link5, 1.7,
                 inertia<Link5, 0.020031100000000003, 0.018080783000000003, 0.005050282999999999,
                         3.5700000000000005e-06, 1.319999999999967e-05, 1.2919999999999998e-05>> {};

struct Link6_home : direction_cosines<Link6_home, Link5, 1, 0, 0, 0, 0, -1, 0, 1, 0> {};
struct Link6 : rotated<Link6, Link6_home, q<6>, Link6_home::z> {};
struct Link6_joint : offset<Link6_joint, Link5_joint, 0.2155 * Link5::z> {};
struct Link6_center : offset<Link6_center, Link6_joint, 0.0006 * Link6::y + 0.0004 * Link6::z> {};
struct Link6_body
    : rigid_body<
          Link6_body, Link6_center, Link6, 1.8,
          effective_inertia<inertia<Link6, 0.000499064, 0.0035997119999999997, 0.004699352, 0, 4.32e-07>>> {};

struct Link7_home : direction_cosines<Link7_home, Link6, -1, 0, 0, 0, 0, 1, 0, 1, 0> {};
struct Link7 : rotated<Link7, Link7_home, q<7>, Link7_home::z> {};
struct Link7_joint : offset<Link7_joint, Link6_joint, 0.081 * Link6::y> {};
struct Link7_center : offset<Link7_center, Link7_joint, 0.02 * Link7::z> {};
struct Link7_body
    : rigid_body<Link7_body, Link7_center, Link7, 0.3, inertia<Link7, 0.00088, 0.00088, 0.001>> {};

struct System
    : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>, q<4>, q<5>, q<6>, q<7>>,
                  speeds<u<1>, u<2>, u<3>, u<4>, u<5>, u<6>, u<7>>,
                  kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>, dot(q<4>) == u<4>,
                             dot(q<5>) == u<5>, dot(q<6>) == u<6>, dot(q<7>) == u<7>>,
                  inputs<T<1>, T<2>, T<3>, T<4>, T<5>, T<6>, T<7>>,
                  bodies<Link1_body, Link2_body, Link3_body, Link4_body, Link5_body, Link6_body, Link7_body>,
                  loads<gravity<-9.81 * N::z>, torque<Link1, T<1> * Link1::z>, torque<Link2, T<2> * Link2::z>,
                        torque<Link1, -T<2> * Link2::z>, torque<Link3, T<3> * Link3::z>,
                        torque<Link2, -T<3> * Link3::z>, torque<Link4, T<4> * Link4::z>,
                        torque<Link3, -T<4> * Link4::z>, torque<Link5, T<5> * Link5::z>,
                        torque<Link4, -T<5> * Link5::z>, torque<Link6, T<6> * Link6::z>,
                        torque<Link5, -T<6> * Link6::z>, torque<Link7, T<7> * Link7::z>,
                        torque<Link6, -T<7> * Link7::z>>> {};

} // namespace iiwa

#line 1 "/work/h_planted/examples/models/iiwa_by_joints.hpp"
namespace iiwa_by_joints {

using namespace kanexpr;

using over = home<-1, 0, 0, 0, 0, 1, 0, 1, 0>;  // the axis along y of the previous link
using under = home<1, 0, 0, 0, 0, -1, 0, 1, 0>; // and in the opposite direction
template <class Self, class Parent, auto place, class Home, auto m, auto x, auto y, auto z, auto... scalars>
using link = pin<Self, Parent, axis<own::z>, at<place>, Home,
                 body<m, double(x) * own::x + double(y) * own::y + z * own::z, inertia<own, scalars...>>>;

struct Ground : inertial_ground<Ground> {};
struct Link1 : pin<Link1, Ground, axis<own::z>, at<0.1575 * Ground::z>,
                   body<4, -0.03 * own::y + 0.12 * own::z, inertia<own, 0.1, 0.09000000000000001, 0.02>>> {};
struct Link2 : link<Link2, Link1, 0.2025 * Link1::z, over, 4, 0.0003, 0.059, 0.042, 0.050019999999999995,
                    0.01794364, 0.04397564, 7.079999999999999e-05, 0.009912, 5.04e-05> {};
struct Link3 : link<Link3, Link2, 0.2045 * Link2::y, over, 3, 0, 0.03, 0.13, 0.07999999999999999,
                    0.07500000000000001, 0.01> {};
struct Link4 : link<Link4, Link3, 0.2155 * Link3::z, under, 2.7, 0, 0.067, 0.034, 0.029958499999999992,
                    0.0099788, 0.028979699999999997, 0, 5.060000000000047e-05> {};
struct Link5 : link<Link5, Link4, 0.1845 * Link4::y, over, 1.7, 0.0001, 0.021, 0.07599999999999998,
                    0.020031100000000003, 0.018080783000000003, 0.005050282999999999, 3.5700000000000005e-06,
                    1.319999999999967e-05, 1.2919999999999998e-05> {};
using light = effective_inertia<inertia<own, 0.000499064, 0.0035997119999999997, 0.004699352, 0, 4.32e-07>>;
struct Link6 : pin<Link6, Link5, axis<own::z>, at<0.2155 * Link5::z>, under,
                   body<1.8, 0.0006 * own::y + 0.0004 * own::z, light>> {};
struct Link7 : link<Link7, Link6, 0.081 * Link6::y, over, 0.3, 0, 0, 0.02, 0.00088, 0.00088, 0.001> {};
struct System : kane_system<inertial<Ground>, joints<Link1, Link2, Link3, Link4, Link5, Link6, Link7>,
                            loads<gravity<-9.81 * Ground::z>, motor<Link1>, motor<Link2>, motor<Link3>,
                                  motor<Link4>, motor<Link5>, motor<Link6>, motor<Link7>>> {};

} // namespace iiwa_by_joints

#line 1 "/work/h_planted/examples/models/n_pendulum_cart.hpp"
namespace n_pendulum_cart {

using namespace kanexpr;
using namespace kanexpr::units;

template <int i>
constexpr coordinate<"q", i, i == 0 ? meter : radian> q; // q<0> is the position of the cart
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr parameter<"m", i, kilogram> m;
template <int i>
constexpr parameter<"l", i, meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr input<"F", newton> F;

struct N : inertial_frame<N> {}; // y points up
struct O : origin<O, N> {};

template <int i>
struct Rod : rotated<Rod<i>, N, q<i + 1>, N::z> {};

template <int i>
struct P : offset<P<i>, P<i - 1>, l<i - 1> * Rod<i - 1>::x> {};
template <>
struct P<0> : offset<P<0>, O, q<0> * N::x> {}; // the cart

template <int i>
struct Bob : particle<Bob<i>, P<i>, m<i>> {};

template <class Bobs, class Rods>
struct chain;
template <int... bob, int... rod>
struct chain<std::integer_sequence<int, bob...>, std::integer_sequence<int, rod...>>
    : kane_system<inertial<N>, coordinates<q<bob>...>, speeds<u<bob>...>,
                  kinematics<(dot(q<bob>) == u<bob>)...>, parameters<m<bob>..., l<rod>..., g>, inputs<F>,
                  bodies<Bob<bob>...>, loads<gravity<-g * N::y>, force<P<0>, F * N::x>>> {};

template <int n>
struct System : chain<std::make_integer_sequence<int, n + 1>, std::make_integer_sequence<int, n>> {};

template <class Bobs, class Rods>
struct lagrange_chain;
template <int... bob, int... rod>
struct lagrange_chain<std::integer_sequence<int, bob...>, std::integer_sequence<int, rod...>>
    : lagrange_system<inertial<N>, coordinates<q<bob>...>, parameters<m<bob>..., l<rod>..., g>, inputs<F>,
                      bodies<Bob<bob>...>, loads<gravity<-g * N::y>, force<P<0>, F * N::x>>> {};

template <int n>
struct LagrangeSystem
    : lagrange_chain<std::make_integer_sequence<int, n + 1>, std::make_integer_sequence<int, n>> {};

} // namespace n_pendulum_cart

#line 1 "/work/h_planted/examples/models/pendulum6.hpp"
namespace pendulum6 {

using namespace kanexpr;
using namespace kanexpr::units;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;

constexpr int length = 1, mass = 1;

struct N : inertial_frame<N> {}; // y points up

template <int i>
struct Rod : rotated<Rod<i>, Rod<i - 1>, q<i>, N::z> {};
template <>
struct Rod<1> : rotated<Rod<1>, N, q<1>, N::z> {};

template <int i>
struct Hinge : offset<Hinge<i>, Hinge<i - 1>, length * Rod<i - 1>::x> {};
template <>
struct Hinge<1> : origin<Hinge<1>, N> {};

template <int i>
struct Middle : offset<Middle<i>, Hinge<i>, length * Rod<i>::x / 2> {};

template <int i>
struct Body : rigid_body<Body<i>, Middle<i>, Rod<i>, mass,
                         inertia<Rod<i>, 0, rational<1, 12> * mass * length * length,
                                 rational<1, 12> * mass * length * length>> {};

struct System : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>, q<4>, q<5>, q<6>>,
                            speeds<u<1>, u<2>, u<3>, u<4>, u<5>, u<6>>,
                            kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>,
                                       dot(q<4>) == u<4>, dot(q<5>) == u<5>, dot(q<6>) == u<6>>,
                            bodies<Body<1>, Body<2>, Body<3>, Body<4>, Body<5>, Body<6>>,
                            loads<gravity<-9.81 * N::y>>> {};

} // namespace pendulum6

#line 1 "/work/h_planted/examples/models/pendulum_nonminimal.hpp"
namespace pendulum_nonminimal {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", meter> q1;
constexpr coordinate<"q2", meter> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"L", meter> L;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // x points down

struct O : origin<O, N> {};
struct P : offset<P, O, q1 * N::x + q2 * N::y> {};

struct Bob : particle<Bob, P, m> {};

struct System
    : kane_system<inertial<N>, coordinates<q2, q1>, speeds<u2, u1>, kinematics<dot(q1) == u1, dot(q2) == u2>,
                  configuration_constraints<q1 * q1 + q2 * q2 == L * L>, dependent<q1, u1>, bodies<Bob>,
                  loads<gravity<g * N::x>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q2, q1>, configuration_constraints<q1 * q1 + q2 * q2 == L * L>,
                      dependent<q1, dot(q1)>, bodies<Bob>, loads<gravity<g * N::x>>> {};

} // namespace pendulum_nonminimal

#line 1 "/work/h_planted/examples/models/pivot_body.hpp"
namespace pivot_body {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"e0"> e0;
constexpr coordinate<"e1"> e1;
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"Ixx", kilogram * pow<2>(meter)> Ixx;
constexpr parameter<"Iyy", kilogram * pow<2>(meter)> Iyy;
constexpr parameter<"Izz", kilogram * pow<2>(meter)> Izz;
constexpr parameter<"Ixy", kilogram * pow<2>(meter)> Ixy;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"a", meter> a; // from the joint to the mass center
constexpr parameter<"b", meter> b;
constexpr parameter<"c", meter> c;
constexpr input<"T1", newton * meter> T1;
constexpr input<"T2", newton * meter> T2;
constexpr input<"T3", newton * meter> T3;

struct N : inertial_frame<N> {}; // z points up
struct B : quaternion<B, N, e0, e1, e2, e3>, angular_velocity<N, u1 * own::x + u2 * own::y + u3 * own::z> {};

struct O : origin<O, N> {};
struct G : offset<G, O, a * B::x + b * B::y + c * B::z> {};

struct Body : rigid_body<Body, G, B, m, inertia<B, Ixx, Iyy, Izz, Ixy>> {};

struct System : kane_system<inertial<N>, coordinates<e0, e1, e2, e3>, speeds<u1, u2, u3>,
                            kinematics<kinematics_of<B, N>>, inputs<T1, T2, T3>, bodies<Body>,
                            loads<gravity<-g * N::z>, torque<B, T1 * B::x + T2 * B::y + T3 * B::z>>> {};

} // namespace pivot_body

#line 1 "/work/h_planted/examples/models/puma.hpp"
namespace puma {

using namespace kanexpr;
using namespace kanexpr::units;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr input<"T", i, newton * meter> T;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};

struct Link1 : rotated<Link1, N, q<1>, N::z> {};
struct Link1_center : offset<Link1_center, O, 0.011 * Link1::x - 0.013 * Link1::y + 0.017 * Link1::z> {};
struct Link1_body : rigid_body<Link1_body, Link1_center, Link1, 13,
                               effective_inertia<inertia<Link1, 0.1, 0.1, 0.35, 0.011000000000000001,
                                                         0.005000000000000001, -0.007000000000000002>>> {};

struct Link2_home : direction_cosines<Link2_home, Link1, 1, 0, 0, 0, 0, 1, 0, -1, 0> {};
struct Link2 : rotated<Link2, Link2_home, q<2>, Link2_home::z> {};
struct Link2_center
    : offset<Link2_center, O, 0.0801 * Link2::x - 0.0083 * Link2::y + 0.002700000000000001 * Link2::z> {};
struct Link2_body
    : rigid_body<Link2_body, Link2_center, Link2, 17.4,
                 inertia<Link2, 0.13, 0.524, 0.539, 0.01573, 0.007150000000000001, -0.010010000000000002>> {};

struct Link3 : rotated<Link3, Link2, q<3>, Link2::z> {};
struct Link3_joint : offset<Link3_joint, O, 0.4318 * Link2::x + 0.15005 * Link2::z> {};
struct Link3_center
    : offset<Link3_center, Link3_joint,
             0.013199999999999998 * Link3::x - 0.08560000000000001 * Link3::y + 0.0344 * Link3::z> {};
struct Link3_body
    : rigid_body<Link3_body, Link3_center, Link3, 4.8,
                 effective_inertia<inertia<Link3, 0.066, 0.012500000000000004, 0.086, 0.0016500000000000004,
                                           0.0007500000000000024, -0.0010500000000000002>>> {};

struct Link4_home : direction_cosines<Link4_home, Link3, 1, 0, 0, 0, 0, 1, 0, -1, 0> {};
struct Link4 : rotated<Link4, Link4_home, q<4>, Link4_home::z> {};
struct Link4_joint : offset<Link4_joint, Link3_joint, 0.0203 * Link3::x + 0.4318 * Link3::y> {};
struct Link4_center : offset<Link4_center, Link4_joint,
                             0.0143 * Link4::x - 0.0169 * Link4::y + 0.003100000000000002 * Link4::z> {};
struct Link4_body : rigid_body<Link4_body, Link4_center, Link4, 0.82,
                               inertia<Link4, 0.0018000000000000002, 0.0018000000000000002, 0.0013,
                                       0.00018590000000000007, 8.45e-05, -0.0001183>> {};

struct Link5_home : direction_cosines<Link5_home, Link4, 1, 0, 0, 0, 0, -1, 0, 1, 0> {};
struct Link5 : rotated<Link5, Link5_home, q<5>, Link5_home::z> {};
struct Link5_center
    : offset<Link5_center, Link4_joint,
             0.015399999999999999 * Link5::x - 0.018199999999999997 * Link5::y + 0.0238 * Link5::z> {};
struct Link5_body
    : rigid_body<
          Link5_body, Link5_center, Link5, 0.34,
          inertia<Link5, 0.0003, 0.0003, 0.0004, 4.62e-05, 2.099999999999997e-05, -2.9399999999999956e-05>> {
};

struct Link6_home : direction_cosines<Link6_home, Link5, 1, 0, 0, 0, 0, 1, 0, -1, 0> {};
struct Link6 : rotated<Link6, Link6_home, q<6>, Link6_home::z> {};
struct Link6_center
    : offset<Link6_center, Link4_joint, 0.0165 * Link6::x - 0.0195 * Link6::y + 0.0575 * Link6::z> {};
struct Link6_body
    : rigid_body<Link6_body, Link6_center, Link6, 0.09,
                 inertia<Link6, 0.00014999999999999996, 0.00015000000000000001, 3.9999999999999996e-05,
                         6.600000000000001e-06, 3.000000000000005e-06, -4.199999999999994e-06>> {};

struct System : kane_system<inertial<N>, coordinates<q<1>, q<2>, q<3>, q<4>, q<5>, q<6>>,
                            speeds<u<1>, u<2>, u<3>, u<4>, u<5>, u<6>>,
                            kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>,
                                       dot(q<4>) == u<4>, dot(q<5>) == u<5>, dot(q<6>) == u<6>>,
                            inputs<T<1>, T<2>, T<3>, T<4>, T<5>, T<6>>,
                            bodies<Link1_body, Link2_body, Link3_body, Link4_body, Link5_body, Link6_body>,
                            loads<gravity<-9.81 * N::z>, torque<Link1, T<1> * Link1::z>,
                                  torque<Link2, T<2> * Link2::z>, torque<Link1, -T<2> * Link2::z>,
                                  torque<Link3, T<3> * Link3::z>, torque<Link2, -T<3> * Link3::z>,
                                  torque<Link4, T<4> * Link4::z>, torque<Link3, -T<4> * Link4::z>,
                                  torque<Link5, T<5> * Link5::z>, torque<Link4, -T<5> * Link5::z>,
                                  torque<Link6, T<6> * Link6::z>, torque<Link5, -T<6> * Link6::z>>> {};

} // namespace puma

#line 1 "/work/h_planted/examples/models/quadruped.hpp"
namespace quadruped {

using namespace kanexpr;
using namespace kanexpr::units;

template <int i>
constexpr coordinate<"q", i, radian> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr input<"T", i, newton * meter> T;

constexpr coordinate<"px", meter> px; // the base in the ground frame
constexpr coordinate<"py", meter> py;
constexpr coordinate<"pz", meter> pz;
constexpr coordinate<"e1"> e1; // its orientation, a unit quaternion
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr speed<"v1"> v1; // its velocity, in its own axes
constexpr speed<"v2"> v2;
constexpr speed<"v3"> v3;
constexpr speed<"w1"> w1; // its angular velocity, in its own axes
constexpr speed<"w2"> w2;
constexpr speed<"w3"> w3;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};

struct Base : quaternion<Base, N, e0, e1, e2, e3>,
              angular_velocity<N, w1 * own::x + w2 * own::y + w3 * own::z> {};
constexpr auto v = v1 * Base::x + v2 * Base::y + v3 * Base::z;
struct B : offset<B, O, px * N::x + py * N::y + pz * N::z>, velocity<N, v> {};

struct Trunk_center
    : offset<Trunk_center, B, -0.013955938 * Base::x - 0.00018214522 * Base::y + 0.008853551 * Base::z> {};
struct Trunk : rigid_body<Trunk, Trunk_center, Base, 26.499758,
                          inertia<Base, 0.22576516760923182, 1.7901879964777738, 1.8315150105098976,
                                  0.008176215580863093, -0.001152977957601977, 0.03787830826727563>> {};

struct LF_Hip_home : direction_cosines<LF_Hip_home, Base, 0, 0, 1, 0, 1, 0, -1, 0, 0> {};
struct LF_Hip : rotated<LF_Hip, LF_Hip_home, q<1>, LF_Hip_home::z> {};
struct LF_Hip_joint : offset<LF_Hip_joint, B, 0.2999 * Base::x + 0.104 * Base::y> {};
struct LF_Hip_center
    : offset<LF_Hip_center, LF_Hip_joint,
             0.0004608417 * LF_Hip::x + 0.017393887 * LF_Hip::y + 0.05666062599999999 * LF_Hip::z> {};
struct LF_Hip_body
    : rigid_body<LF_Hip_body, LF_Hip_center, LF_Hip, 2.781,
                 inertia<LF_Hip, 0.005832953740724128, 0.004938301180765766, 0.0032955263298053454,
                         -0.00013580793106751296, -4.453414921273867e-05, 9.791292577996257e-05>> {};

struct LF_Thigh_home : direction_cosines<LF_Thigh_home, LF_Hip, 0, 1, 0, 0, 0, 1, 1, 0, 0> {};
struct LF_Thigh : rotated<LF_Thigh, LF_Thigh_home, q<2>, LF_Thigh_home::z> {};
struct LF_Thigh_joint : offset<LF_Thigh_joint, LF_Hip_joint, 0.08381 * LF_Hip::y + 0.0599 * LF_Hip::z> {};
struct LF_Thigh_center
    : offset<LF_Thigh_center, LF_Thigh_joint,
             -4.649951e-05 * LF_Thigh::x + 0.24569573999999997 * LF_Thigh::y + 0.030814718 * LF_Thigh::z> {};
struct LF_Thigh_body
    : rigid_body<LF_Thigh_body, LF_Thigh_center, LF_Thigh, 3.071,
                 inertia<LF_Thigh, 0.0299040575128294, 0.004861085297586836, 0.02956379923498295,
                         9.44801495048826e-05, -0.004142428983421046, -4.42918815827975e-05>> {};

struct LF_Shank : rotated<LF_Shank, LF_Thigh, q<3>, LF_Thigh::z> {};
struct LF_Shank_joint : offset<LF_Shank_joint, LF_Thigh_joint, 0.285 * LF_Thigh::y + 0.1003 * LF_Thigh::z> {};
struct LF_Shank_center
    : offset<LF_Shank_center, LF_Shank_joint,
             0.06125277 * LF_Shank::x + 0.080659784 * LF_Shank::y + 0.0054619997 * LF_Shank::z> {};
struct LF_Shank_body
    : rigid_body<LF_Shank_body, LF_Shank_center, LF_Shank, 0.58842,
                 inertia<LF_Shank, 0.008810379442595948, 0.001549783830428502, 0.010161141959404669,
                         -0.0018193534370272197, 2.2660021774642368e-05, 5.3571221778904356e-05>> {};

struct RF_Hip_home : direction_cosines<RF_Hip_home, Base, 0, 0, 1, 0, 1, 0, -1, 0, 0> {};
struct RF_Hip : rotated<RF_Hip, RF_Hip_home, q<4>, RF_Hip_home::z> {};
struct RF_Hip_joint : offset<RF_Hip_joint, B, 0.2999 * Base::x - 0.104 * Base::y> {};
struct RF_Hip_center
    : offset<RF_Hip_center, RF_Hip_joint,
             0.0004608417 * RF_Hip::x - 0.017393887 * RF_Hip::y + 0.056763320000000006 * RF_Hip::z> {};
struct RF_Hip_body
    : rigid_body<RF_Hip_body, RF_Hip_center, RF_Hip, 2.781,
                 inertia<RF_Hip, 0.005834774767550156, 0.004940121207591795, 0.0032955263298053454,
                         0.00013580886106751296, -4.5030006006880046e-05, -0.00010000399551079924>> {};

struct RF_Thigh_home : direction_cosines<RF_Thigh_home, RF_Hip, 0, 1, 0, 0, 0, 1, 1, 0, 0> {};
struct RF_Thigh : rotated<RF_Thigh, RF_Thigh_home, q<5>, RF_Thigh_home::z> {};
struct RF_Thigh_joint : offset<RF_Thigh_joint, RF_Hip_joint, -0.08381 * RF_Hip::y + 0.0599 * RF_Hip::z> {};
struct RF_Thigh_center
    : offset<RF_Thigh_center, RF_Thigh_joint,
             4.649951e-05 * RF_Thigh::x + 0.24569573999999997 * RF_Thigh::y - 0.030814718 * RF_Thigh::z> {};
struct RF_Thigh_body
    : rigid_body<RF_Thigh_body, RF_Thigh_center, RF_Thigh, 3.071,
                 inertia<RF_Thigh, 0.0299040575128294, 0.004861084997586836, 0.02956379923498295,
                         -0.00011479378950488258, 0.004142425983421048, -4.43959235827975e-05>> {};

struct RF_Shank : rotated<RF_Shank, RF_Thigh, q<6>, RF_Thigh::z> {};
struct RF_Shank_joint : offset<RF_Shank_joint, RF_Thigh_joint, 0.285 * RF_Thigh::y - 0.1003 * RF_Thigh::z> {};
struct RF_Shank_center
    : offset<RF_Shank_center, RF_Shank_joint,
             0.06125277 * RF_Shank::x + 0.080659784 * RF_Shank::y - 0.005461999 * RF_Shank::z> {};
struct RF_Shank_body
    : rigid_body<RF_Shank_body, RF_Shank_center, RF_Shank, 0.58842,
                 inertia<RF_Shank, 0.008810379447095477, 0.0015497840349280316, 0.010161141959404669,
                         -0.0018193534370272197, -2.266071855136132e-05, -5.357133654925589e-05>> {};

struct LH_Hip_home : direction_cosines<LH_Hip_home, Base, 0, 0, 1, 0, 1, 0, -1, 0, 0> {};
struct LH_Hip : rotated<LH_Hip, LH_Hip_home, q<7>, LH_Hip_home::z> {};
struct LH_Hip_joint : offset<LH_Hip_joint, B, -0.2999 * Base::x + 0.104 * Base::y> {};
struct LH_Hip_center : offset<LH_Hip_center, LH_Hip_joint,
                              0.00046084123000000003 * LH_Hip::x + 0.017393887 * LH_Hip::y -
                                  0.056763320000000006 * LH_Hip::z> {};
struct LH_Hip_body
    : rigid_body<LH_Hip_body, LH_Hip_center, LH_Hip, 2.781,
                 inertia<LH_Hip, 0.005834772767550157, 0.0049401212087965, 0.0032955263310100492,
                         -0.00013580900380254083, -4.502980600688041e-05, 0.00010000421970443191>> {};

struct LH_Thigh_home : direction_cosines<LH_Thigh_home, LH_Hip, 0, 1, 0, 0, 0, 1, 1, 0, 0> {};
struct LH_Thigh : rotated<LH_Thigh, LH_Thigh_home, q<8>, LH_Thigh_home::z> {};
struct LH_Thigh_joint : offset<LH_Thigh_joint, LH_Hip_joint, 0.08381 * LH_Hip::y - 0.0599 * LH_Hip::z> {};
struct LH_Thigh_center
    : offset<LH_Thigh_center, LH_Thigh_joint,
             -4.649951e-05 * LH_Thigh::x + 0.24569573999999997 * LH_Thigh::y + 0.030814718 * LH_Thigh::z> {};
struct LH_Thigh_body
    : rigid_body<LH_Thigh_body, LH_Thigh_center, LH_Thigh, 3.071,
                 inertia<LH_Thigh, 0.0299040575128294, 0.004861085297586836, 0.02956379923498295,
                         0.0001147941395048826, -0.004142428983421046, -4.43958835827975e-05>> {};

struct LH_Shank : rotated<LH_Shank, LH_Thigh, q<9>, LH_Thigh::z> {};
struct LH_Shank_joint : offset<LH_Shank_joint, LH_Thigh_joint, 0.285 * LH_Thigh::y + 0.1003 * LH_Thigh::z> {};
struct LH_Shank_center
    : offset<LH_Shank_center, LH_Shank_joint,
             -0.06125277 * LH_Shank::x + 0.080659784 * LH_Shank::y + 0.005461999 * LH_Shank::z> {};
struct LH_Shank_body
    : rigid_body<LH_Shank_body, LH_Shank_center, LH_Shank, 0.58842,
                 inertia<LH_Shank, 0.008810379447095477, 0.0015497840349280316, 0.010161141959404669,
                         0.0018193534370272197, 2.2660128551361318e-05, -5.3571326549255903e-05>> {};

struct RH_Hip_home : direction_cosines<RH_Hip_home, Base, 0, 0, 1, 0, 1, 0, -1, 0, 0> {};
struct RH_Hip : rotated<RH_Hip, RH_Hip_home, q<10>, RH_Hip_home::z> {};
struct RH_Hip_joint : offset<RH_Hip_joint, B, -0.2999 * Base::x - 0.104 * Base::y> {};
struct RH_Hip_center
    : offset<RH_Hip_center, RH_Hip_joint,
             0.00046084123000000003 * RH_Hip::x - 0.017393887 * RH_Hip::y - 0.05666062599999999 * RH_Hip::z> {
};
struct RH_Hip_body
    : rigid_body<RH_Hip_body, RH_Hip_center, RH_Hip, 2.781,
                 inertia<RH_Hip, 0.005832953740724128, 0.004938300181970471, 0.0032955263310100492,
                         0.0001358085338025408, -4.453434921273874e-05, -9.791282272055816e-05>> {};

struct RH_Thigh_home : direction_cosines<RH_Thigh_home, RH_Hip, 0, 1, 0, 0, 0, 1, 1, 0, 0> {};
struct RH_Thigh : rotated<RH_Thigh, RH_Thigh_home, q<11>, RH_Thigh_home::z> {};
struct RH_Thigh_joint : offset<RH_Thigh_joint, RH_Hip_joint, -0.08381 * RH_Hip::y - 0.0599 * RH_Hip::z> {};
struct RH_Thigh_center
    : offset<RH_Thigh_center, RH_Thigh_joint,
             4.649951e-05 * RH_Thigh::x + 0.24569573999999997 * RH_Thigh::y - 0.030814718 * RH_Thigh::z> {};
struct RH_Thigh_body
    : rigid_body<RH_Thigh_body, RH_Thigh_center, RH_Thigh, 3.071,
                 inertia<RH_Thigh, 0.0299040575128294, 0.004861084997586836, 0.02956379923498295,
                         -9.447977950488259e-05, 0.004142425983421048, -4.42919215827975e-05>> {};

struct RH_Shank : rotated<RH_Shank, RH_Thigh, q<12>, RH_Thigh::z> {};
struct RH_Shank_joint : offset<RH_Shank_joint, RH_Thigh_joint, 0.285 * RH_Thigh::y - 0.1003 * RH_Thigh::z> {};
struct RH_Shank_center
    : offset<RH_Shank_center, RH_Shank_joint,
             -0.06125277 * RH_Shank::x + 0.080659784 * RH_Shank::y - 0.0054619987 * RH_Shank::z> {};
struct RH_Shank_body
    : rigid_body<RH_Shank_body, RH_Shank_center, RH_Shank, 0.58842,
                 inertia<RH_Shank, 0.008810379449023846, 0.0015497840368564014, 0.010161141959404669,
                         0.0018193534370272197, -2.266087431281223e-05, 5.357147573654939e-05>> {};

struct System
    : kane_system<
          inertial<N>,
          coordinates<px, py, pz, e1, e2, e3, e0, q<1>, q<2>, q<3>, q<4>, q<5>, q<6>, q<7>, q<8>, q<9>, q<10>,
                      q<11>, q<12>>,
          speeds<v1, v2, v3, w1, w2, w3, u<1>, u<2>, u<3>, u<4>, u<5>, u<6>, u<7>, u<8>, u<9>, u<10>, u<11>,
                 u<12>>,
          kinematics<
              dot(px) == dot(v, N::x), dot(py) == dot(v, N::y), dot(pz) == dot(v, N::z),
              dot(e1) == (e0 * w1 + e2 * w3 - e3 * w2) / 2, dot(e2) == (e0 * w2 + e3 * w1 - e1 * w3) / 2,
              dot(e3) == (e0 * w3 + e1 * w2 - e2 * w1) / 2, dot(e0) == (-e1 * w1 - e2 * w2 - e3 * w3) / 2,
              dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>, dot(q<4>) == u<4>, dot(q<5>) == u<5>,
              dot(q<6>) == u<6>, dot(q<7>) == u<7>, dot(q<8>) == u<8>, dot(q<9>) == u<9>, dot(q<10>) == u<10>,
              dot(q<11>) == u<11>, dot(q<12>) == u<12>>,
          inputs<T<1>, T<2>, T<3>, T<4>, T<5>, T<6>, T<7>, T<8>, T<9>, T<10>, T<11>, T<12>>,
          bodies<Trunk, LF_Hip_body, LF_Thigh_body, LF_Shank_body, RF_Hip_body, RF_Thigh_body, RF_Shank_body,
                 LH_Hip_body, LH_Thigh_body, LH_Shank_body, RH_Hip_body, RH_Thigh_body, RH_Shank_body>,
          loads<gravity<-9.81 * N::z>, torque<LF_Hip, T<1> * LF_Hip::z>, torque<Base, -T<1> * LF_Hip::z>,
                torque<LF_Thigh, T<2> * LF_Thigh::z>, torque<LF_Hip, -T<2> * LF_Thigh::z>,
                torque<LF_Shank, T<3> * LF_Shank::z>, torque<LF_Thigh, -T<3> * LF_Shank::z>,
                torque<RF_Hip, T<4> * RF_Hip::z>, torque<Base, -T<4> * RF_Hip::z>,
                torque<RF_Thigh, T<5> * RF_Thigh::z>, torque<RF_Hip, -T<5> * RF_Thigh::z>,
                torque<RF_Shank, T<6> * RF_Shank::z>, torque<RF_Thigh, -T<6> * RF_Shank::z>,
                torque<LH_Hip, T<7> * LH_Hip::z>, torque<Base, -T<7> * LH_Hip::z>,
                torque<LH_Thigh, T<8> * LH_Thigh::z>, torque<LH_Hip, -T<8> * LH_Thigh::z>,
                torque<LH_Shank, T<9> * LH_Shank::z>, torque<LH_Thigh, -T<9> * LH_Shank::z>,
                torque<RH_Hip, T<10> * RH_Hip::z>, torque<Base, -T<10> * RH_Hip::z>,
                torque<RH_Thigh, T<11> * RH_Thigh::z>, torque<RH_Hip, -T<11> * RH_Thigh::z>,
                torque<RH_Shank, T<12> * RH_Shank::z>, torque<RH_Thigh, -T<12> * RH_Shank::z>>> {};

} // namespace quadruped

#line 1 "/work/h_planted/examples/models/rattleback.hpp"
namespace rattleback {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", radian> q1; // yaw
constexpr coordinate<"q2", radian> q2; // roll
constexpr coordinate<"q3", radian> q3; // pitch
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"a", meter> a; // semi-axes of the ellipsoid
constexpr parameter<"b", meter> b;
constexpr parameter<"c", meter> c;
constexpr parameter<"h", meter> h; // from its center down to the mass center
constexpr parameter<"m", kilogram> m;
constexpr parameter<"Ixx", kilogram * pow<2>(meter)> Ixx;
constexpr parameter<"Iyy", kilogram * pow<2>(meter)> Iyy;
constexpr parameter<"Izz", kilogram * pow<2>(meter)> Izz;
constexpr parameter<"Ixy", kilogram * pow<2>(meter)> Ixy;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"sigma", newton * meter * second / radian>
    sigma; // friction: torque over angular velocity

struct N : inertial_frame<N> {}; // z points up
struct B : body_fixed<B, N, "zxy", q1, q2, q3>,
           angular_velocity<N, u1 * own::x + u2 * own::y + u3 * own::z> {};

// The lowest point of the ellipsoid, from its center.
constexpr auto stretched =
    a * a * dot(N::z, B::x) * B::x + b * b * dot(N::z, B::y) * B::y + c * c * dot(N::z, B::z) * B::z;
constexpr auto lowest = -stretched / sqrt(dot(stretched, N::z));

constexpr auto friction = -sigma * (u1 * B::x + u2 * B::y + u3 * B::z);

struct P : origin<P, N> {}; // contact: no velocity in N
struct G : offset<G, P, -lowest - h * B::z>, fixed_in<B> {};

struct Stone : rigid_body<Stone, G, B, m, inertia<B, Ixx, Iyy, Izz, Ixy>> {};

struct System
    : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>, kinematics<kinematics_of<B, N>>,
                  bodies<Stone>, loads<gravity<-g * N::z>, torque<B, friction>>> {};

} // namespace rattleback

#line 1 "/work/h_planted/examples/models/rocket.hpp"
namespace rocket {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q", meter> q;
constexpr speed<"u"> u;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"cd", kilogram / meter> cd; // drag divided by the square of the speed
constexpr prescribed<"m", kilogram> m;          // mass, a known function of time
constexpr input<"T", newton> T;

struct N : inertial_frame<N> {}; // z points up

struct O : origin<O, N> {};
struct P : offset<P, O, q * N::z> {};

struct Rocket : particle<Rocket, P, m> {};

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, inputs<m, dot(m), T>,
                  bodies<Rocket>, loads<force<P, (T - m * g - cd * u * u) * N::z>>> {};

struct LagrangeSystem : lagrange_system<inertial<N>, coordinates<q>, inputs<m, dot(m), T>, bodies<Rocket>,
                                        loads<force<P, (T - m * g - cd * dot(q) * dot(q)) * N::z>>> {};

} // namespace rocket

#line 1 "/work/h_planted/examples/models/rolling_disc.hpp"
namespace rolling_disc {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"r", meter> r;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {};
struct Y : rotated<Y, N, q1, N::z> {}; // yaw
struct L : rotated<L, Y, q2, Y::x> {}; // lean
struct R : rotated<R, L, q3, L::y>,    // spin, with the speeds chosen by hand
           angular_velocity<N, u1 * L::x + u2 * L::y + u3 * L::z> {};

struct C : origin<C, N> {};            // contact: no velocity in N
struct Dmc : offset<Dmc, C, r * L::z>, // mass center, with the contact fixed in R
             fixed_in<R> {};

struct Disc : rigid_body<Disc, Dmc, R, m, inertia<L, m * r * r / 4, m * r * r / 2, m * r * r / 4>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                            kinematics<dot(q1) == u3 / cos(q2), dot(q2) == u1, dot(q3) == u2 - u3 * tan(q2)>,
                            bodies<Disc>, loads<force<Dmc, -m * g * Y::z>>> {};

} // namespace rolling_disc

#line 1 "/work/h_planted/examples/models/rolling_disc_constrained.hpp"
namespace rolling_disc_constrained {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr coordinate<"q4", meter> q4;
constexpr coordinate<"q5", meter> q5;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"u4"> u4;
constexpr speed<"u5"> u5;
constexpr parameter<"r", meter> r;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {};
struct Y : rotated<Y, N, q1, N::z> {}; // yaw
struct L : rotated<L, Y, q2, Y::x> {}; // lean
struct R : rotated<R, L, q3, L::y>,    // spin
           angular_velocity<N, u1 * L::x + u2 * L::y + u3 * L::z> {};

struct O : origin<O, N> {}; // the position on the ground
struct Dmc : offset<Dmc, O, q4 * N::x + q5 * N::y + r * cos(q2) * N::z> {};
struct Contact : offset<Contact, Dmc, -r * L::z>,
                 fixed_in<R> {}; // the point of the rim that touches the ground

struct Disc : rigid_body<Disc, Dmc, R, m, inertia<L, m * r * r / 4, m * r * r / 2, m * r * r / 4>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3, q4, q5>, speeds<u1, u2, u3, u4, u5>,
                            kinematics<kinematics_of<R, N>, dot(q4) == u4, dot(q5) == u5>,
                            velocity_constraints<zero_along<velocity_of<Contact>, N::x, N::y>>,
                            dependent<u4, u5>, bodies<Disc>, loads<gravity<-g * N::z>>> {};

/// The same disc, with the rates of the coordinates as speeds.
namespace by_rates {

struct R : rotated<R, L, q3, L::y> {};
struct Contact : offset<Contact, Dmc, -r * L::z>, fixed_in<R> {};

struct Disc : rigid_body<Disc, Dmc, R, m, inertia<L, m * r * r / 4, m * r * r / 2, m * r * r / 4>> {};

} // namespace by_rates

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q1, q2, q3, q4, q5>,
                      velocity_constraints<zero_along<velocity_of<by_rates::Contact>, N::x, N::y>>,
                      dependent<dot(q4), dot(q5)>, bodies<by_rates::Disc>, loads<gravity<-g * N::z>>> {};

} // namespace rolling_disc_constrained

#line 1 "/work/h_planted/examples/models/rolling_torus.hpp"
namespace rolling_torus {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"R", meter> R; // from the center to the middle of the tube
constexpr parameter<"a", meter> a; // radius of the tube
constexpr parameter<"m", kilogram> m;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {};
struct Y : rotated<Y, N, q1, N::z> {}; // yaw
struct L : rotated<L, Y, q2, Y::x> {}; // lean
struct B : rotated<B, L, q3, L::y>,    // spin
           angular_velocity<N, u1 * L::x + u2 * L::y + u3 * L::z> {};

struct C : origin<C, N> {};                                   // contact: no velocity in N
struct G : offset<G, C, a * N::z + R * L::z>, fixed_in<B> {}; // mass center

constexpr auto along_axis = m * (R * R + 3 * a * a / 4);
constexpr auto across_axis = m * (R * R / 2 + 5 * a * a / 8);

struct Torus : rigid_body<Torus, G, B, m, inertia<L, across_axis, along_axis, across_axis>> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                            kinematics<dot(q1) == u3 / cos(q2), dot(q2) == u1, dot(q3) == u2 - u3 * tan(q2)>,
                            bodies<Torus>, loads<gravity<-g * N::z>>> {};

/// The same torus, with the position of its center among the coordinates and rolling as a constraint.
namespace by_rates {

constexpr coordinate<"q4", meter> q4;
constexpr coordinate<"q5", meter> q5;

struct B : rotated<B, L, q3, L::y> {};

struct O : origin<O, N> {}; // the position on the ground
struct G : offset<G, O, q4 * N::x + q5 * N::y + (a + R * cos(q2)) * N::z> {};
struct Contact : offset<Contact, G, -a * N::z - R * L::z>, fixed_in<B> {};

struct Torus : rigid_body<Torus, G, B, m, inertia<L, across_axis, along_axis, across_axis>> {};

} // namespace by_rates

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q1, q2, q3, by_rates::q4, by_rates::q5>,
                      velocity_constraints<zero_along<velocity_of<by_rates::Contact>, N::x, N::y>>,
                      dependent<dot(by_rates::q4), dot(by_rates::q5)>, bodies<by_rates::Torus>,
                      loads<gravity<-g * N::z>>> {};

} // namespace rolling_torus

#line 1 "/work/h_planted/examples/models/rotating_tube.hpp"
namespace rotating_tube {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q", meter> q; // along the tube
constexpr speed<"u"> u;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"k", newton / meter> k;
constexpr parameter<"q0", meter> q0; // unstretched length of the spring
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"c", newton * second / meter> c;
constexpr prescribed<"theta", radian> theta; // angle of the tube, a known function of time

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, theta, N::z> {};

struct O : origin<O, N> {};
struct P : offset<P, O, q * A::x> {};

struct Bead : particle<Bead, P, m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            inputs<theta, dot(theta), dot(dot(theta))>, bodies<Bead>,
                            loads<gravity<-g * N::y>, force<P, -(k*(q - q0) + c * u) * A::x>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q>, inputs<theta, dot(theta), dot(dot(theta))>, bodies<Bead>,
                      loads<gravity<-g * N::y>, force<P, -(k*(q - q0) + c * dot(q)) * A::x>>> {};

} // namespace rotating_tube

#line 1 "/work/h_planted/examples/models/simple_pendulum.hpp"
namespace simple_pendulum {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q", radian> q;
constexpr speed<"u"> u;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"c", newton * meter * second / radian> c;
constexpr input<"T", newton * meter> T;

struct N : inertial_frame<N> {}; // x points down
struct A : rotated<A, N, q, N::z> {};

struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};

struct Bob : particle<Bob, P, m> {};

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, g, c>,
                  inputs<T>, bodies<Bob>, loads<gravity<g * N::x>, torque<A, (T - c * u) * N::z>>> {};

struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q>, parameters<m, l, g, c>, inputs<T>, bodies<Bob>,
                      loads<gravity<g * N::x>, torque<A, (T - c * dot(q)) * N::z>>> {};

} // namespace simple_pendulum

#line 1 "/work/h_planted/examples/models/spinning_top.hpp"
namespace spinning_top {

using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr coordinate<"q3", radian> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"A", kilogram * pow<2>(meter)> A; // moment of inertia about a transverse axis
constexpr parameter<"C", kilogram * pow<2>(meter)> C; // and about the spin axis

struct N : inertial_frame<N> {};
struct F1 : rotated<F1, N, q1, N::z> {};   // precession
struct F2 : rotated<F2, F1, q2, F1::x> {}; // nutation
struct B : rotated<B, F2, q3, F2::z>,      // spin
           angular_velocity<N, u1 * F2::x + u2 * F2::y + u3 * F2::z> {};

struct O : origin<O, N> {};                         // tip
struct G : offset<G, O, l * F2::z>, fixed_in<B> {}; // mass center

struct Top : rigid_body<Top, G, B, m, inertia<F2, A, A, C>> {};

struct System
    : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                  kinematics<u1 == dot(q2), u2 == dot(q1) * sin(q2), u3 == dot(q3) + dot(q1) * cos(q2)>,
                  parameters<m, l, g, A, C>, bodies<Top>, loads<gravity<-g * N::z>>> {};

/// The same top, with the rates of the angles as speeds.
namespace by_rates {

struct B : rotated<B, F2, q3, F2::z> {};

struct G : offset<G, O, l * F2::z> {};

struct Top : rigid_body<Top, G, B, m, inertia<F2, A, A, C>> {};

} // namespace by_rates

struct LagrangeSystem : lagrange_system<inertial<N>, coordinates<q1, q2, q3>, parameters<m, l, g, A, C>,
                                        bodies<by_rates::Top>, loads<gravity<-g * N::z>>> {};

} // namespace spinning_top

namespace crane {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"theta", radian> theta;
constexpr speed<"v"> v;
constexpr speed<"omega"> omega;
constexpr parameter<"m1", kilogram> m1; // trolley
constexpr parameter<"m2", kilogram> m2; // load
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr input<"F", newton> F;

struct N : inertial_frame<N> {};          // y points up
struct A : rotated<A, N, theta, N::z> {}; // the rope
struct O : origin<O, N> {};
struct C : offset<C, O, x * N::x> {};
struct P : offset<P, C, -l * A::y> {};
struct Trolley : particle<Trolley, C, m1> {};
struct Load : particle<Load, P, m2> {};
struct System : kane_system<inertial<N>, coordinates<x, theta>, speeds<v, omega>, kinematics<simple>,
                            parameters<m1, m2, l, g>, bodies<Trolley, Load>,
                            loads<gravity<-g * N::y>, force<C, F * N::x>>> {};
}

namespace differential {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr parameter<"J", kilogram * pow<2>(meter)> J;            // of the cage
constexpr parameter<"J_w", kilogram * pow<2>(meter)> Jw;         // of a wheel with its shaft
constexpr parameter<"J_p", kilogram * pow<2>(meter)> Jp;         // of the planet gear about its axis
constexpr parameter<"c_l", newton * meter * second / radian> cl; // resistance of the left wheel
constexpr parameter<"c_r", newton * meter * second / radian> cr; // and of the right one
constexpr input<"T", newton * meter> T;                          // of the engine, on the cage

struct Car : inertial_ground<Car> {}; // y along the axle, to the left
struct Cage : pin<Cage, Car, axis<Car::y>, body<5, 0.0 * own::x, inertia<own, 0, J, 0>>> {};
struct Planet : pin<Planet, Cage, axis<Cage::x>, body<0.2, 0.0 * own::x, inertia<own, Jp, Jp, Jp>>> {};
struct Left : pin<Left, Cage, axis<Cage::y>, body<10, 0.0 * own::x, inertia<own, 0, Jw, 0>>> {};
struct Right : pin<Right, Cage, axis<Cage::y>, body<10, 0.0 * own::x, inertia<own, 0, Jw, 0>>> {};

constexpr auto left_speed = dot(angular_velocity_of<Left>, Car::y);
constexpr auto right_speed = dot(angular_velocity_of<Right>, Car::y);

struct System : kane_system<inertial<Car>, joints<Cage, Planet, Left, Right>,
                            configuration_constraints<gear<Left, Planet, -1>, gear<Right, Planet, 1>>,
                            dependent<q_of<Left>, q_of<Right>, u_of<Left>, u_of<Right>>, inputs<T>,
                            loads<torque<Cage, T * Car::y>, torque<Left, -cl * left_speed * Car::y>,
                                  torque<Right, -cr * right_speed * Car::y>>> {};
}

namespace falling_cat {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"x", meter> x; // of the waist
constexpr coordinate<"y", meter> y;
constexpr coordinate<"z", meter> z;
constexpr coordinate<"e1"> e1; // orientation of the rear half, a unit quaternion
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr speed<"v1"> v1;
constexpr speed<"v2"> v2;
constexpr speed<"v3"> v3;
constexpr speed<"w1"> w1; // angular velocity of the rear half, in its axes
constexpr speed<"w2"> w2;
constexpr speed<"w3"> w3;
constexpr prescribed<"beta", radian> beta;            // how far the waist is bent
constexpr prescribed<"psi", radian> psi;              // in which direction
constexpr parameter<"m", kilogram> m;                 // of each half
constexpr parameter<"h", meter> h;                    // from the waist to its mass center
constexpr parameter<"I", kilogram * pow<2>(meter)> I; // moment of inertia about the spine
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // and across it
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // z points up
struct A : quaternion<A, N, e0, e1, e2, e3>, angular_velocity<N, w1 * own::x + w2 * own::y + w3 * own::z> {};
// The halves bend without twisting: the direction of the bend goes around, and the front half does not.
struct D : rotated<D, A, psi, A::x> {};
struct E : rotated<E, D, beta, D::y> {};
struct B : rotated<B, E, -psi, E::x> {};

struct O : origin<O, N> {};
struct Waist : offset<Waist, O, x * N::x + y * N::y + z * N::z>,
               velocity<N, v1 * N::x + v2 * N::y + v3 * N::z> {};
struct Rear : offset<Rear, Waist, -h * A::x> {};
struct Front : offset<Front, Waist, h * B::x> {};
struct RearHalf : rigid_body<RearHalf, Rear, A, m, inertia<A, I, J, J>> {};
struct FrontHalf : rigid_body<FrontHalf, Front, B, m, inertia<B, I, J, J>> {};

struct System
    : kane_system<inertial<N>, coordinates<x, y, z, e1, e2, e3, e0>, speeds<v1, v2, v3, w1, w2, w3>,
                  kinematics<dot(x) == v1, dot(y) == v2, dot(z) == v3, kinematics_of<A, N>>,
                  parameters<m, h, I, J, g>, bodies<RearHalf, FrontHalf>, loads<gravity<-g * N::z>>> {};
}

namespace foucault {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"x", meter> x; // east
constexpr coordinate<"y", meter> y; // north
constexpr coordinate<"z", meter> z;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"Omega", radian / second> Omega; // of the Earth
constexpr parameter<"lambda", radian> lambda;        // latitude

struct N : inertial_frame<N> {}; // east, north, up: the Coriolis force stands for the Earth's rotation
struct O : origin<O, N> {};      // the suspension
struct P : offset<P, O, x * N::x + y * N::y + z * N::z> {};
struct Bob : particle<Bob, P, m> {};

constexpr auto earth = Omega * (cos(lambda) * N::y + sin(lambda) * N::z);
constexpr auto coriolis = -2 * m * cross(earth, velocity_of<P>);

struct System : kane_system<inertial<N>, coordinates<x, y, z>, speeds<u1, u2, u3>, kinematics<simple>,
                            configuration_constraints<x * x + y * y + z * z == l * l>, dependent<z, u3>,
                            parameters<m, l, g, Omega, lambda>, bodies<Bob>,
                            loads<gravity<-g * N::z>, force<P, coriolis>>> {};
}

namespace furuta {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"phi", radian> phi;     // of the arm
constexpr coordinate<"theta", radian> theta; // of the pendulum, zero where it stands
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // of the arm and the motor about the vertical
constexpr parameter<"m", kilogram> m;
constexpr parameter<"r", meter> r;                    // length of the arm
constexpr parameter<"d", meter> d;                    // from the joint to the pendulum's mass center
constexpr parameter<"I", kilogram * pow<2>(meter)> I; // of the pendulum about it
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr input<"T", newton * meter> T;

struct N : inertial_frame<N> {}; // z points up
struct A : rotated<A, N, phi, N::z> {};
struct B : rotated<B, A, theta, A::x> {};
struct O : origin<O, N> {};
struct Elbow : offset<Elbow, O, r * A::x> {};
struct G : offset<G, Elbow, d * B::z> {};
struct Arm : rigid_body<Arm, O, A, 0.1, inertia<A, 0, 0, J>> {};
struct Rod : rigid_body<Rod, G, B, m, inertia<B, I, I, 0>> {};

struct System : kane_system<inertial<N>, coordinates<phi, theta>, speeds<u1, u2>, kinematics<simple>,
                            parameters<J, m, r, d, I, g>, inputs<T>, bodies<Arm, Rod>,
                            loads<gravity<-g * N::z>, torque<A, T * N::z>>> {};
}

namespace gyrocompass {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"alpha", radian> alpha; // from north to the axis of the rotor, toward west
constexpr speed<"u"> u;
constexpr speed<"s", radian / second> s;             // spin of the rotor relative to its gimbal
constexpr parameter<"Omega", radian / second> Omega; // of the Earth
constexpr parameter<"lambda", radian> lambda;        // latitude
constexpr parameter<"m", kilogram> m;
constexpr parameter<"A", kilogram * pow<2>(meter)> A; // moment of inertia of the rotor across its axis
constexpr parameter<"C", kilogram * pow<2>(meter)> C; // and about it
constexpr parameter<"c", newton * meter * second / radian> c; // damping of the gimbal
constexpr time_variable t;

struct N : inertial_frame<N> {};                                                 // at t = 0: east, north, up
struct E : rotated<E, N, Omega * t, cos(lambda) * N::y + sin(lambda) * N::z> {}; // the Earth
struct F : rotated<F, E, alpha, E::z> {};                                        // the gimbal, level
struct R : rotated<R, F, 0, F::y>, angular_velocity<F, s * F::y> {};             // the rotor
struct O : origin<O, N> {};
struct Rotor : rigid_body<Rotor, O, R, m, inertia<F, A, C, A>> {};

struct System : kane_system<inertial<N>, coordinates<alpha>, speeds<u, s>, kinematics<dot(alpha) == u>,
                            parameters<Omega, lambda, m, A, C, c>, bodies<Rotor>,
                            loads<torque_between<F, E, -c * u * F::z>>> {};
}

namespace kapitza {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"theta", radian> theta; // zero where the pendulum hangs
constexpr speed<"u"> u;
constexpr prescribed<"y", meter> y; // height of the pivot
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"c", newton * meter * second / radian> c;

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, theta, N::z> {};
struct O : origin<O, N> {};
struct Pivot : offset<Pivot, O, y * N::y> {};
struct P : offset<P, Pivot, -l * A::y> {};
struct Bob : particle<Bob, P, m> {};

struct System
    : kane_system<inertial<N>, coordinates<theta>, speeds<u>, kinematics<dot(theta) == u>,
                  parameters<m, l, g, c>, bodies<Bob>, loads<gravity<-g * N::y>, torque<A, -c * u * N::z>>> {
};
}

namespace roller_racer {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"theta", radian> theta;
constexpr speed<"u1"> u1; // of the joint, along the seat
constexpr speed<"u2"> u2; // and across it
constexpr speed<"u3"> u3;
constexpr prescribed<"beta", radian> beta; // the handlebars, relative to the seat
constexpr parameter<"m1", kilogram> m1;
constexpr parameter<"m2", kilogram> m2;
constexpr parameter<"I1", kilogram * pow<2>(meter)> I1;
constexpr parameter<"I2", kilogram * pow<2>(meter)> I2;
constexpr parameter<"d1", meter> d1; // from the joint back to the rear axle
constexpr parameter<"d2", meter> d2; // from the joint ahead to the front axle; negative if it trails

struct N : inertial_frame<N> {}; // z points up
struct A : rotated<A, N, theta, N::z>, angular_velocity<N, u3 * N::z> {};
struct B : rotated<B, A, beta, A::z> {};

constexpr auto v = u1 * A::x + u2 * A::y;
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x + y * N::y>, velocity<N, v> {};
struct Rear : offset<Rear, P, -d1 * A::x> {};
struct Front : offset<Front, P, d2 * B::x> {};

struct Seat : rigid_body<Seat, Rear, A, m1, inertia<A, 0, 0, I1>> {};
struct Bars : rigid_body<Bars, Front, B, m2, inertia<B, 0, 0, I2>> {};

struct System
    : kane_system<
          inertial<N>, coordinates<x, y, theta>, speeds<u1, u2, u3>,
          kinematics<dot(x) == dot(v, N::x), dot(y) == dot(v, N::y), dot(theta) == u3>,
          velocity_constraints<zero_along<velocity_of<Rear>, A::y>, zero_along<velocity_of<Front>, B::y>>,
          dependent<u2, u3>, bodies<Seat, Bars>> {};
}

namespace satellite {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"e1"> e1; // the orientation, a unit quaternion
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr speed<"w1"> w1; // angular velocity, in the satellite's axes
constexpr speed<"w2"> w2;
constexpr speed<"w3"> w3;
constexpr speed<"s1", radian / second> s1; // spin of the wheels relative to the satellite
constexpr speed<"s2", radian / second> s2;
constexpr speed<"s3", radian / second> s3;
constexpr parameter<"I1", kilogram * pow<2>(meter)> I1;
constexpr parameter<"I2", kilogram * pow<2>(meter)> I2;
constexpr parameter<"I3", kilogram * pow<2>(meter)> I3;
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // of a wheel about its axis
constexpr input<"T1", newton * meter> T1;
constexpr input<"T2", newton * meter> T2;
constexpr input<"T3", newton * meter> T3;

struct N : inertial_frame<N> {};
struct B : quaternion<B, N, e0, e1, e2, e3>, angular_velocity<N, w1 * own::x + w2 * own::y + w3 * own::z> {};
struct W1 : rotated<W1, B, 0, B::x>, angular_velocity<B, s1 * B::x> {};
struct W2 : rotated<W2, B, 0, B::y>, angular_velocity<B, s2 * B::y> {};
struct W3 : rotated<W3, B, 0, B::z>, angular_velocity<B, s3 * B::z> {};
struct O : origin<O, N> {};
struct Hull : rigid_body<Hull, O, B, 60, inertia<B, I1, I2, I3>> {}; // with the wheels, but for their spin
struct Wheel1 : rigid_body<Wheel1, O, W1, 0.0, inertia<B, J, 0, 0>> {};
struct Wheel2 : rigid_body<Wheel2, O, W2, 0.0, inertia<B, 0, J, 0>> {};
struct Wheel3 : rigid_body<Wheel3, O, W3, 0.0, inertia<B, 0, 0, J>> {};

struct System : kane_system<inertial<N>, coordinates<e1, e2, e3, e0>, speeds<w1, w2, w3, s1, s2, s3>,
                            kinematics<kinematics_of<B, N>>, parameters<I1, I2, I3, J>, inputs<T1, T2, T3>,
                            bodies<Hull, Wheel1, Wheel2, Wheel3>,
                            loads<torque_between<W1, B, T1 * B::x>, torque_between<W2, B, T2 * B::y>,
                                  torque_between<W3, B, T3 * B::z>>> {};
}

namespace slider_crank {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"q1", radian> q1; // of the crank
constexpr coordinate<"q2", radian> q2; // of the rod, relative to the crank
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"r", meter> r;                    // crank
constexpr parameter<"l", meter> l;                    // rod
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // flywheel
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"M", kilogram> M; // piston
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // x points up, along the cylinder
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::z> {};
struct O : origin<O, N> {};
struct C : offset<C, O, r * A::x> {};
struct G : offset<G, C, l / 2 * B::x> {};
struct P : offset<P, C, l * B::x> {};
struct Flywheel : rigid_body<Flywheel, O, A, 1, inertia<A, 0, 0, J>> {};
struct Rod : rigid_body<Rod, G, B, m, inertia<B, 0, 0, I>> {};
struct Piston : particle<Piston, P, M> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, kinematics<simple>,
                            configuration_constraints<zero_along<position_of<P, O>, N::y>>, dependent<q2, u2>,
                            bodies<Flywheel, Rod, Piston>, loads<gravity<-g * N::x>>> {};
}

namespace snakeboard {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"theta", radian> theta;
constexpr speed<"u1"> u1; // along the board
constexpr speed<"u2"> u2; // across it
constexpr speed<"u3"> u3;
constexpr prescribed<"psi", radian> psi; // the rider's body, relative to the board
constexpr prescribed<"phi", radian> phi; // the front wheels; the rear ones turn the other way
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l; // half of the board's length
constexpr parameter<"J", kilogram * pow<2>(meter)> J;
constexpr parameter<"J_r", kilogram * pow<2>(meter)> Jr; // of the rider
constexpr parameter<"J_w", kilogram * pow<2>(meter)> Jw; // of the wheels at one end

struct N : inertial_frame<N> {}; // z points up
struct A : rotated<A, N, theta, N::z>, angular_velocity<N, u3 * N::z> {};
struct B : rotated<B, A, psi, A::z> {};
struct F : rotated<F, A, phi, A::z> {};
struct R : rotated<R, A, -phi, A::z> {};

constexpr auto v = u1 * A::x + u2 * A::y;
struct O : origin<O, N> {};
struct G : offset<G, O, x * N::x + y * N::y>, velocity<N, v> {};
struct Front : offset<Front, G, l * A::x> {};
struct Rear : offset<Rear, G, -l * A::x> {};

struct Board : rigid_body<Board, G, A, m, inertia<A, 0, 0, J>> {};
struct Rider : rigid_body<Rider, G, B, 0.0, inertia<B, 0, 0, Jr>> {};
struct FrontWheels : rigid_body<FrontWheels, Front, F, 0.0, inertia<F, 0, 0, Jw>> {};
struct RearWheels : rigid_body<RearWheels, Rear, R, 0.0, inertia<R, 0, 0, Jw>> {};

struct System
    : kane_system<
          inertial<N>, coordinates<x, y, theta>, speeds<u1, u2, u3>,
          kinematics<dot(x) == dot(v, N::x), dot(y) == dot(v, N::y), dot(theta) == u3>,
          velocity_constraints<zero_along<velocity_of<Front>, F::y>, zero_along<velocity_of<Rear>, R::y>>,
          dependent<u2, u3>, bodies<Board, Rider, FrontWheels, RearWheels>> {};
}

namespace spherical_pendulum {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"theta", radian> theta;
constexpr coordinate<"phi", radian> phi;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // z points up
struct Y : rotated<Y, N, phi, N::z> {};
struct A : rotated<A, Y, -theta, Y::y> {};

struct O : origin<O, N> {};
struct P : offset<P, O, -l * A::z> {};
struct Bob : particle<Bob, P, m> {};

struct System : kane_system<inertial<N>, coordinates<theta, phi>, speeds<u1, u2>, kinematics<simple>,
                            parameters<m, l, g>, bodies<Bob>, loads<gravity<-g * N::z>>> {};
}

namespace stewart {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"z", meter> z;
constexpr coordinate<"a", radian> a; // roll, pitch and yaw
constexpr coordinate<"b", radian> b;
constexpr coordinate<"c", radian> c;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"u4"> u4;
constexpr speed<"u5"> u5;
constexpr speed<"u6"> u6;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"J", kilogram * pow<2>(meter)> J;
constexpr parameter<"g", meter / pow<2>(second)> g;
template <int i>
constexpr input<"F", i, newton> F; // along leg i

struct N : inertial_frame<N> {}; // z points up
struct P : body_fixed<P, N, "xyz", a, b, c> {};
struct O : origin<O, N> {};
struct C : offset<C, O, x * N::x + y * N::y + z * N::z> {};

// Hexagons with sides of two lengths: the legs meet in pairs below and above, turned by 60 degrees.
struct place {
  double x, y;
};
constexpr double below = 1.2, above = 0.7; // radii, m
constexpr place feet[6]{{0.9848, 0.1736},   {-0.3420, 0.9397},  {-0.6428, 0.7660},
                        {-0.6428, -0.7660}, {-0.3420, -0.9397}, {0.9848, -0.1736}};
constexpr place tops[6]{{0.6428, 0.7660},   {0.3420, 0.9397},  {-0.9848, 0.1736},
                        {-0.9848, -0.1736}, {0.3420, -0.9397}, {0.6428, -0.7660}};

template <int i>
struct Foot : offset<Foot<i>, O, below * feet[i].x * N::x + below * feet[i].y * N::y> {};
template <int i>
struct Top : offset<Top<i>, C, above * tops[i].x * P::x + above * tops[i].y * P::y> {};
template <int i>
using leg = force_between<Top<i>, Foot<i>, F<i> * normalized(position_of<Top<i>, Foot<i>>)>;

struct Platform : rigid_body<Platform, C, P, m, inertia<P, I, I, J>> {};
struct System : kane_system<inertial<N>, coordinates<x, y, z, a, b, c>, speeds<u1, u2, u3, u4, u5, u6>,
                            kinematics<simple>, parameters<m, I, J, g>,
                            inputs<F<0>, F<1>, F<2>, F<3>, F<4>, F<5>>, bodies<Platform>,
                            loads<gravity<-g * N::z>, leg<0>, leg<1>, leg<2>, leg<3>, leg<4>, leg<5>>> {};
}

namespace tippe_top {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"e1"> e1; // the orientation, a unit quaternion
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr speed<"v1"> v1; // of the sphere's center
constexpr speed<"v2"> v2;
constexpr speed<"w1"> w1; // angular velocity, in the axes of the top
constexpr speed<"w2"> w2;
constexpr speed<"w3"> w3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"R", meter> R;                    // radius of the sphere
constexpr parameter<"a", meter> a;                    // from its center down to the mass center
constexpr parameter<"A", kilogram * pow<2>(meter)> A; // moment of inertia across the stem
constexpr parameter<"C", kilogram * pow<2>(meter)> C; // and about it
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"mu", dimensionless> mu;
constexpr parameter<"s", meter / second> s; // the sliding speed below which friction becomes viscous

struct N : inertial_frame<N> {}; // z points up
struct B : quaternion<B, N, e0, e1, e2, e3>, angular_velocity<N, w1 * own::x + w2 * own::y + w3 * own::z> {};
struct O : origin<O, N> {};
struct S : offset<S, O, x * N::x + y * N::y + R * N::z>, velocity<N, v1 * N::x + v2 * N::y> {};
struct G : offset<G, S, -a * B::z> {};
struct P : offset<P, S, -R * N::z>, fixed_in<B> {}; // the point that slides on the table

// Coulomb friction under the weight, smooth where the sliding stops.
constexpr auto sliding = velocity_of<P>;
constexpr auto friction =
    -mu * m * g /
    sqrt(dot(sliding, N::x) * dot(sliding, N::x) + dot(sliding, N::y) * dot(sliding, N::y) + s * s) * sliding;

struct Top : rigid_body<Top, G, B, m, inertia<B, A, A, C>> {};

struct System : kane_system<inertial<N>, coordinates<x, y, e1, e2, e3, e0>, speeds<v1, v2, w1, w2, w3>,
                            kinematics<dot(x) == v1, dot(y) == v2, kinematics_of<B, N>>,
                            parameters<m, R, a, A, C, g, mu, s>, bodies<Top>,
                            loads<gravity<-g * N::z>, force<P, friction>>> {};
}

namespace tumbling_racket {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"e1"> e1; // the orientation, a unit quaternion
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr speed<"w1"> w1; // the angular velocity, in the axes of the body
constexpr speed<"w2"> w2;
constexpr speed<"w3"> w3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"A", kilogram * pow<2>(meter)> A;
constexpr parameter<"B", kilogram * pow<2>(meter)> B;
constexpr parameter<"C", kilogram * pow<2>(meter)> C;

struct N : inertial_frame<N> {};
struct F : quaternion<F, N, e0, e1, e2, e3>, angular_velocity<N, w1 * own::x + w2 * own::y + w3 * own::z> {};
struct O : origin<O, N> {};
struct Nut : rigid_body<Nut, O, F, m, inertia<F, A, B, C>> {};
struct System : kane_system<inertial<N>, coordinates<e1, e2, e3, e0>, speeds<w1, w2, w3>,
                            kinematics<kinematics_of<F, N>>, parameters<A, B, C, m>, bodies<Nut>> {};
}

namespace turntable {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"phi", radian> phi; // of the table
constexpr speed<"v1"> v1;
constexpr speed<"v2"> v2;
constexpr speed<"w1", radian / second> w1; // angular velocity of the ball, in axes that do not turn
constexpr speed<"w2", radian / second> w2;
constexpr speed<"w3", radian / second> w3;
constexpr parameter<"Omega", radian / second> Omega;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"r", meter> r;

struct N : inertial_frame<N> {}; // z points up
struct T : rotated<T, N, phi, N::z>, angular_velocity<N, Omega * N::z> {};
struct B : rotated<B, N, 0, N::z>,
           angular_velocity_apart_from_orientation<N, w1 * N::x + w2 * N::y + w3 * N::z> {};
struct O : origin<O, N> {};
struct G : offset<G, O, x * N::x + y * N::y + r * N::z>, velocity<N, v1 * N::x + v2 * N::y> {};
struct OnBall : offset<OnBall, G, -r * N::z>, fixed_in<B> {};

struct Ball
    : rigid_body<Ball, G, B, m,
                 changing_inertia<inertia<N, 2 * m * r * r / 5, 2 * m * r * r / 5, 2 * m * r * r / 5>>> {};

struct System : kane_system<inertial<N>, coordinates<x, y, phi>, speeds<v1, v2, w1, w2, w3>,
                            kinematics<dot(x) == v1, dot(y) == v2, dot(phi) == Omega>,
                            velocity_constraints<dot(velocity_of<OnBall>, N::x) == -Omega * y,
                                                 dot(velocity_of<OnBall>, N::y) == Omega * x>,
                            dependent<w1, w2>, bodies<Ball>> {};
}

namespace wheelset {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"y", meter> y;      // across the track
constexpr coordinate<"psi", radian> psi; // yaw
constexpr speed<"v"> v;
constexpr speed<"omega"> omega;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"V", meter / second> V; // speed of the vehicle
constexpr parameter<"b", meter> b;          // half of the distance between the rails
constexpr parameter<"r", meter> r;          // radius of the wheels
constexpr parameter<"gamma", dimensionless> conicity;
constexpr parameter<"f", newton> f;            // creep coefficient
constexpr parameter<"k_y", newton / meter> ky; // suspension
constexpr parameter<"k_psi", newton * meter / radian> kpsi;
constexpr parameter<"k_3", newton / pow<3>(meter)> k3; // flanges

struct N : inertial_frame<N> {}; // moves with the vehicle; x points ahead, z up
struct A : rotated<A, N, psi, N::z> {};
struct O : origin<O, N> {};
struct G : offset<G, O, y * N::y> {};

// Kalker's linear creep forces at both wheels, for lateral motion and yaw.
constexpr auto lateral = -2 * f * (v / V - psi) - ky * y - k3 * y * y * y;
constexpr auto yawing = -2 * f * b * (conicity * y / r + b * omega / V) - kpsi * psi;

struct Wheelset : rigid_body<Wheelset, G, A, m, inertia<A, I, 0, I>> {};
struct System : kane_system<inertial<N>, coordinates<y, psi>, speeds<v, omega>, kinematics<simple>,
                            parameters<m, I, V, b, r, conicity, f, ky, kpsi, k3>, bodies<Wheelset>,
                            loads<force<G, lateral * N::y>, torque<A, yawing * N::z>>> {};
}

namespace wilberforce {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"z", meter> z;
constexpr coordinate<"theta", radian> theta;
constexpr speed<"v"> v;
constexpr speed<"omega"> omega;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"k", newton / meter> k;                  // stiffness against stretching
constexpr parameter<"delta", newton * meter / radian> delta; // and against twisting
constexpr parameter<"epsilon", newton / radian> epsilon;     // their coupling

struct N : inertial_frame<N> {}; // z points up; z = 0 where the weight is balanced
struct B : rotated<B, N, theta, N::z> {};
struct O : origin<O, N> {};
struct G : offset<G, O, z * N::z> {};
struct Weight : rigid_body<Weight, G, B, m, inertia<B, I, I, I>> {};

struct System
    : kane_system<inertial<N>, coordinates<z, theta>, speeds<v, omega>, kinematics<simple>, bodies<Weight>,
                  loads<potential_energy<(k * z * z + delta * theta * theta + epsilon * z * theta) / 2>>> {};
}

namespace bouncing_ball {


using namespace kanexpr;
using namespace kanexpr::units;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"h", meter> h; // height of its lowest point
constexpr speed<"vx"> vx;
constexpr speed<"vh"> vh;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"R", meter> R;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // z points up
struct O : origin<O, N> {};
struct Centre : offset<Centre, O, x * N::x + (h + R) * N::z> {};
struct Ball : particle<Ball, Centre, m> {};

struct System
    : kane_system<inertial<N>, coordinates<x, h>, speeds<vx, vh>, kinematics<dot(x) == vx, dot(h) == vh>,
                  parameters<m, R, g>, bodies<Ball>, loads<gravity<-g * N::z>>> {};
}

template<class S> void check(const char* n){ auto m=kanexpr::derive<S>(); std::cout<<"== "<<n<<std::endl<<kanexpr::symbolic::print(m.mass_matrix())<<std::endl<<kanexpr::symbolic::print(m.forcing())<<std::endl<<m.mistake()<<std::endl; }
int main(){check<andrews::System>("andrews::System");check<arm3::System>("arm3::System");check<arm3::LagrangeSystem>("arm3::LagrangeSystem");check<arm6::System>("arm6::System");check<bicycle::System>("bicycle::System");check<bicycle::BoundSystem>("bicycle::BoundSystem");check<bicycle::SteeredSystem>("bicycle::SteeredSystem");check<chaplygin_sleigh::System>("chaplygin_sleigh::System");check<chaplygin_sleigh::LagrangeSystem>("chaplygin_sleigh::LagrangeSystem");check<double_pendulum::System>("double_pendulum::System");check<double_pendulum::LagrangeSystem>("double_pendulum::LagrangeSystem");check<four_bar::System>("four_bar::System");check<four_bar::LagrangeSystem>("four_bar::LagrangeSystem");check<iiwa::System>("iiwa::System");check<iiwa_by_joints::System>("iiwa_by_joints::System");check<n_pendulum_cart::System<2>>("n_pendulum_cart::System<2>");check<n_pendulum_cart::LagrangeSystem<2>>("n_pendulum_cart::LagrangeSystem<2>");check<pendulum6::System>("pendulum6::System");check<pendulum_nonminimal::System>("pendulum_nonminimal::System");check<pendulum_nonminimal::LagrangeSystem>("pendulum_nonminimal::LagrangeSystem");check<pivot_body::System>("pivot_body::System");check<puma::System>("puma::System");check<quadruped::System>("quadruped::System");check<rattleback::System>("rattleback::System");check<rocket::System>("rocket::System");check<rocket::LagrangeSystem>("rocket::LagrangeSystem");check<rolling_disc::System>("rolling_disc::System");check<rolling_disc_constrained::System>("rolling_disc_constrained::System");check<rolling_disc_constrained::LagrangeSystem>("rolling_disc_constrained::LagrangeSystem");check<rolling_torus::System>("rolling_torus::System");check<rolling_torus::LagrangeSystem>("rolling_torus::LagrangeSystem");check<rotating_tube::System>("rotating_tube::System");check<rotating_tube::LagrangeSystem>("rotating_tube::LagrangeSystem");check<simple_pendulum::System>("simple_pendulum::System");check<simple_pendulum::LagrangeSystem>("simple_pendulum::LagrangeSystem");check<spinning_top::System>("spinning_top::System");check<spinning_top::LagrangeSystem>("spinning_top::LagrangeSystem");check<crane::System>("crane::System");check<differential::System>("differential::System");check<falling_cat::System>("falling_cat::System");check<foucault::System>("foucault::System");check<furuta::System>("furuta::System");check<gyrocompass::System>("gyrocompass::System");check<kapitza::System>("kapitza::System");check<roller_racer::System>("roller_racer::System");check<satellite::System>("satellite::System");check<slider_crank::System>("slider_crank::System");check<snakeboard::System>("snakeboard::System");check<spherical_pendulum::System>("spherical_pendulum::System");check<stewart::System>("stewart::System");check<tippe_top::System>("tippe_top::System");check<tumbling_racket::System>("tumbling_racket::System");check<turntable::System>("turntable::System");check<wheelset::System>("wheelset::System");check<wilberforce::System>("wilberforce::System");check<bouncing_ball::System>("bouncing_ball::System");}