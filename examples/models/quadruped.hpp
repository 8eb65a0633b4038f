#pragma once

#include <kanexpr/kanexpr.hpp>

/// ANYmal: four legs (left and right, front and hind) with three joints each, on a floating base; numeric
/// values are bound in the type. The base's speeds are its velocity and angular velocity in its own axes.
namespace quadruped {

using namespace kanexpr;
using namespace kanexpr::units::si;

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
