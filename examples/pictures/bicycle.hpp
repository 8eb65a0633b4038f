#pragma once

#include <kanexpr/animate.hpp>
#include <models/bicycle.hpp>

/// The appearance of the bicycle. Points are measured from the center of the rear wheel, in frame axes that
/// are level when the bicycle is upright.
namespace bicycle {

namespace shapes {

using Level = LevelFrame;

template <class Self, auto forward, auto left, auto upward>
using on_frame =
    offset<Self, WR_mc, double(forward) * Level::x + double(left) * Level::y + double(upward) * Level::z>;

/// A point relative to the steering axis: `upward` along it from its middle, and to the side.
template <class Self, auto upward, auto left = 0.0, auto forward = 0.0>
using on_fork = offset<Self, Steer, -upward * Fork::x + double(left) * Fork::y + forward * Fork::z>;

struct Cranks : on_frame<Cranks, 0.42, 0, -0.02> {};
struct Seat : on_frame<Seat, 0.24, 0, 0.5> {};
struct SaddleBack : on_frame<SaddleBack, 0.14, 0, 0.56> {};
struct SaddleTip : on_frame<SaddleTip, 0.36, 0, 0.55> {};
struct HeadTop : offset<HeadTop, Steer, -0.28 * Frame::x> {};
struct HeadFoot : offset<HeadFoot, Steer, -0.15 * Frame::x> {};
struct LeftAxleEnd : on_frame<LeftAxleEnd, 0, 0.05, 0> {};
struct RightAxleEnd : on_frame<RightAxleEnd, 0, -0.05, 0> {};

struct Crown : on_fork<Crown, 0.135> {};
struct LeftCrown : on_fork<LeftCrown, 0.13, 0.05> {};
struct RightCrown : on_fork<RightCrown, 0.13, -0.05> {};
struct LeftTip : offset<LeftTip, WF_mc, 0.05 * Fork::y> {};
struct RightTip : offset<RightTip, WF_mc, -0.05 * Fork::y> {};
struct Stem : on_fork<Stem, 0.34> {};
struct Bar : on_fork<Bar, 0.38, 0, 0.05> {};
struct LeftBend : on_fork<LeftBend, 0.39, 0.2, 0.04> {};
struct RightBend : on_fork<RightBend, 0.39, -0.2, 0.04> {};
struct LeftGrip : on_fork<LeftGrip, 0.39, 0.26, -0.1> {};
struct RightGrip : on_fork<RightGrip, 0.39, -0.26, -0.1> {};

struct LeftPedal : on_frame<LeftPedal, 0.58, 0.12, -0.05> {};
struct RightPedal : on_frame<RightPedal, 0.26, -0.12, 0.01> {};
struct LeftCrank : on_frame<LeftCrank, 0.42, 0.07, -0.02> {};
struct RightCrank : on_frame<RightCrank, 0.42, -0.07, -0.02> {};
struct LeftCrankEnd : on_frame<LeftCrankEnd, 0.58, 0.07, -0.05> {};
struct RightCrankEnd : on_frame<RightCrankEnd, 0.26, -0.07, 0.01> {};

struct Hips : on_frame<Hips, 0.22, 0, 0.68> {};
struct LeftHip : on_frame<LeftHip, 0.23, 0.09, 0.65> {};
struct RightHip : on_frame<RightHip, 0.23, -0.09, 0.65> {};
struct LeftKnee : on_frame<LeftKnee, 0.62, 0.12, 0.4> {};
struct RightKnee : on_frame<RightKnee, 0.5, -0.12, 0.44> {};
struct LeftToe : on_frame<LeftToe, 0.64, 0.12, 0.0> {};
struct RightToe : on_frame<RightToe, 0.33, -0.12, 0.05> {};
struct LeftHeel : on_frame<LeftHeel, 0.5, 0.12, 0.02> {};
struct RightHeel : on_frame<RightHeel, 0.19, -0.12, 0.07> {};
struct Chest : on_frame<Chest, 0.42, 0, 1.06> {};
struct LeftShoulder : on_frame<LeftShoulder, 0.43, 0.17, 1.1> {};
struct RightShoulder : on_frame<RightShoulder, 0.43, -0.17, 1.1> {};
struct LeftElbow : on_frame<LeftElbow, 0.56, 0.29, 0.83> {};
struct RightElbow : on_frame<RightElbow, 0.56, -0.29, 0.83> {};
struct Head : on_frame<Head, 0.52, 0, 1.37> {};
struct Neck : on_frame<Neck, 0.5, 0, 1.27> {};

using paint = colour<"#b5382f">;
using steel = colour<"#8f979e">;
using rubber = colour<"#33383d">;
using skin = colour<"#d9a884">;
using shirt = colour<"#3d6b99">;
using trousers = colour<"#4b5563">;

template <class From, class To, auto radius, class... Options>
using bar = show<rod<From, To, radius>, Options...>;

} // namespace shapes

using namespace shapes;

/// Pictures of the bicycle and of systems that extend it.
template <class System>
using picture_of =
    kanexpr::picture<System, up<N::z>, ground<>, carried<WR_mc>, seen_from<N::x - 1.6 * N::y + 0.75 * N::z>,
                     show_forces<"N">, show_velocities<"m/s">, show_frames, plot_energies<"J">,
                     in_unit<"rad", q1, q2, q4, q5>, in_unit<"rad/s", u1, u2, u3, u4, u5, u6>,
                     trace<WR_cont, colour<"#2f5d8a">>, trace<WF_cont, colour<"#d98a2b">>,
                     show<wheel<WR, WR_mc, WR::y, WRrad, 0.035>, spinning<u3>, steel, named<"rear wheel">>,
                     show<wheel<WF, WF_mc, WF::y, WFrad, 0.035>, spinning<u6>, steel, named<"front wheel">>,
                     // the frame
                     bar<Cranks, Seat, 0.018, paint>, bar<Seat, HeadTop, 0.018, paint>,
                     bar<Cranks, HeadFoot, 0.022, paint>, bar<HeadTop, HeadFoot, 0.025, paint>,
                     bar<LeftAxleEnd, Seat, 0.009, paint>, bar<RightAxleEnd, Seat, 0.009, paint>,
                     bar<LeftAxleEnd, Cranks, 0.011, paint>, bar<RightAxleEnd, Cranks, 0.011, paint>,
                     bar<SaddleBack, SaddleTip, 0.035, rubber>, bar<LeftCrank, RightCrank, 0.025, steel>,
                     bar<LeftCrank, LeftCrankEnd, 0.012, steel>, bar<RightCrank, RightCrankEnd, 0.012, steel>,
                     bar<LeftCrankEnd, LeftPedal, 0.018, rubber>,
                     bar<RightCrankEnd, RightPedal, 0.018, rubber>,
                     // the fork
                     bar<LeftCrown, LeftTip, 0.014, steel>, bar<RightCrown, RightTip, 0.014, steel>,
                     bar<LeftCrown, RightCrown, 0.018, steel>, bar<Crown, Stem, 0.017, steel>,
                     bar<Stem, Bar, 0.016, steel>, bar<LeftBend, RightBend, 0.013, steel>,
                     bar<LeftBend, LeftGrip, 0.02, rubber>, bar<RightBend, RightGrip, 0.02, rubber>,
                     // the rider, who is part of the frame
                     bar<Hips, Chest, 0.12, shirt>, bar<LeftHip, RightHip, 0.1, trousers>,
                     bar<LeftShoulder, RightShoulder, 0.075, shirt>, show<sphere<Head, 0.115>, skin>,
                     bar<Chest, Neck, 0.05, skin>, bar<LeftHip, LeftKnee, 0.07, trousers>,
                     bar<RightHip, RightKnee, 0.07, trousers>, bar<LeftKnee, LeftHeel, 0.05, trousers>,
                     bar<RightKnee, RightHeel, 0.05, trousers>, bar<LeftHeel, LeftToe, 0.04, rubber>,
                     bar<RightHeel, RightToe, 0.04, rubber>, bar<LeftShoulder, LeftElbow, 0.045, shirt>,
                     bar<RightShoulder, RightElbow, 0.045, shirt>, bar<LeftElbow, LeftGrip, 0.037, skin>,
                     bar<RightElbow, RightGrip, 0.037, skin>>;

using picture = picture_of<BoundSystem>;

} // namespace bicycle
