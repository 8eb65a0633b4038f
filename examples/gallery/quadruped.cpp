// A quadruped is dropped, pushed to the side, and keeps standing.
#include <kanexpr/simulate.hpp>
#include <models/quadruped.hpp>
#include <parts/page.hpp>

namespace quadruped {

template <class Self, class Shank_joint, class Shank, auto side>
using foot_at =
    offset<Self, Shank_joint, 0.08795 * Shank::x + 0.33797 * Shank::y + double(side) * 0.01305 * Shank::z>;
struct LF_Foot : foot_at<LF_Foot, LF_Shank_joint, LF_Shank, 1> {};
struct RF_Foot : foot_at<RF_Foot, RF_Shank_joint, RF_Shank, -1> {};
struct LH_Foot : offset<LH_Foot, LH_Shank_joint,
                        -0.08795 * LH_Shank::x + 0.33797 * LH_Shank::y + 0.01305 * LH_Shank::z> {};
struct RH_Foot : offset<RH_Foot, RH_Shank_joint,
                        -0.08795 * RH_Shank::x + 0.33797 * RH_Shank::y - 0.01305 * RH_Shank::z> {};

// The ground is a stiff spring with a damper that pushes only, and rubbing feet stick smoothly.
constexpr double radius = 0.03, friction = 0.8; // m, 1
constexpr auto stiffness = constant<2e4, newton / meter>;
constexpr auto damping = constant<1.0, second / meter>;
template <class Foot>
constexpr auto height = dot(position_of<Foot, O>, N::z);
template <class Foot>
constexpr auto normal = stiffness * softplus(radius - height<Foot>, 0.001) /
                        (1 + exp(2 * damping * dot(velocity_of<Foot>, N::z)));
template <class Foot>
constexpr auto along = velocity_of<Foot> - dot(velocity_of<Foot>, N::z) * N::z;
template <class Foot>
using ground_under =
    force<Foot, normal<Foot> * N::z -
                    friction * normal<Foot> / sqrt(dot(along<Foot>, along<Foot>) + 1e-4) * along<Foot>>;

struct Standing : extended<System, loads<ground_under<LF_Foot>, ground_under<RF_Foot>, ground_under<LH_Foot>,
                                         ground_under<RH_Foot>>> {};

template <class From, class To, auto size, class Color>
using limb = show<rod<From, To, size>, Color>;
using shell = colour<"#b5382f">;
using metal = colour<"#8f979e">;
using carbon = colour<"#33383d">;
struct Head : offset<Head, B, 0.33 * Base::x + 0.02 * Base::z> {};

using picture = kanexpr::picture<
    Standing, up<N::z>, ground<>, seen_from<N::x - 1.5 * N::y + 0.6 * N::z>,
    show<box<Base, B, 0.56, 0.24, 0.16>, shell, named<"trunk">>,
    show<box<Base, Head, 0.1, 0.16, 0.1>, carbon>, limb<LF_Hip_joint, LF_Thigh_joint, 0.05, metal>,
    limb<RF_Hip_joint, RF_Thigh_joint, 0.05, metal>, limb<LH_Hip_joint, LH_Thigh_joint, 0.05, metal>,
    limb<RH_Hip_joint, RH_Thigh_joint, 0.05, metal>, limb<LF_Thigh_joint, LF_Shank_joint, 0.04, metal>,
    limb<RF_Thigh_joint, RF_Shank_joint, 0.04, metal>, limb<LH_Thigh_joint, LH_Shank_joint, 0.04, metal>,
    limb<RH_Thigh_joint, RH_Shank_joint, 0.04, metal>, limb<LF_Shank_joint, LF_Foot, 0.02, carbon>,
    limb<RF_Shank_joint, RF_Foot, 0.02, carbon>, limb<LH_Shank_joint, LH_Foot, 0.02, carbon>,
    limb<RH_Shank_joint, RH_Foot, 0.02, carbon>, show<sphere<LF_Foot, radius>, carbon>,
    show<sphere<RF_Foot, radius>, carbon>, show<sphere<LH_Foot, radius>, carbon>,
    show<sphere<RH_Foot, radius>, carbon>>;

} // namespace quadruped

int main(int count, char** words) {
  using namespace quadruped;
  gallery::page page(count, words,
                     {.title = "Quadruped that stands",
                      .kind = "Control",
                      .see = "The robot falls from a few centimeters with a push to the side, gives in at "
                             "the knees, and stands still again. Each "
                             "of its twelve joints is driven like a spring with a damper, and the ground "
                             "pushes only while a foot touches it.",
                      .source = "Hutter and others, ANYmal: a highly mobile and dynamic quadrupedal robot, "
                                "IEEE/RSJ International Conference on "
                                "Intelligent Robots and Systems (2016)"});
  Eigen::Vector<double, 12> pose;
  pose << 0, 0.5, -0.9, 0, 0.5, -0.9, 0, -0.5, 0.9, 0, -0.5, 0.9;
  state<Standing> start;
  start[pz] = 0.58, start[e0] = 1, start[v2] = 0.5;
  start.q().tail(12) = pose;
  const auto run =
      simulate<Standing>(start, {}, {0, 4},
                         {.inputs =
                              [&](double, const state<Standing>& now, input_values<Standing>& r) {
                                r = 300 * (pose - now.q().tail(12)) - 12 * now.u().tail(12);
                              },
                          .relative_tolerance = 1e-6,
                          .output_every = 0.02});
  std::printf("height %g, lean %g, speed %g\n", run.state[pz], 1 - run.state[e0] * run.state[e0],
              run.state.u().norm());
  page.expect(run.state[pz] > 0.35 && run.state[e0] * run.state[e0] > 0.98,
              "the trunk is upright at the end");
  page.expect(run.state.u().norm() < 0.05, "the robot stands still at the end");
  return page.show<quadruped::picture>(run, {.eye = Eigen::Vector3d(0.4, -1, 0.35),
                                             .angles = false,
                                             .lengths = false,
                                             .loads = false,
                                             .names = false});
}
