// A cat that is dropped upside down lands on its feet, without angular momentum.
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/prescribe.hpp>
#include <parts/page.hpp>

namespace falling_cat {

using namespace kanexpr;
using namespace kanexpr::units::si;

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

// Angular momentum about the mass center, half way between those of the halves.
constexpr auto apart = position_of<Front, Rear> / 2;
constexpr auto momentum = I * dot(angular_velocity_of<A>, A::x) * A::x +
                          J * (angular_velocity_of<A> - dot(angular_velocity_of<A>, A::x) * A::x) +
                          I * dot(angular_velocity_of<B>, B::x) * B::x +
                          J * (angular_velocity_of<B> - dot(angular_velocity_of<B>, B::x) * B::x) +
                          m * cross(apart, velocity_of<Front> - velocity_of<Rear>);

template <class Self, class Point, class Frame, auto along, auto left, auto upward>
using on =
    offset<Self, Point, double(along) * Frame::x + double(left) * Frame::y + double(upward) * Frame::z>;

struct RearEnd : on<RearEnd, Rear, A, -0.07, 0, 0> {};
struct FrontEnd : on<FrontEnd, Front, B, 0.06, 0, 0> {};
struct TailTip : on<TailTip, Rear, A, -0.3, 0, 0.1> {};
struct Head : on<Head, Front, B, 0.15, 0, 0.05> {};
struct LeftEar : on<LeftEar, Head, B, -0.01, 0.032, 0.05> {};
struct RightEar : on<RightEar, Head, B, -0.01, -0.032, 0.05> {};
struct Nose : on<Nose, Head, B, 0.05, 0, -0.008> {};
struct LeftHip : on<LeftHip, Rear, A, -0.06, 0.045, -0.02> {};
struct RightHip : on<RightHip, Rear, A, -0.06, -0.045, -0.02> {};
struct LeftHind : on<LeftHind, Rear, A, -0.09, 0.055, -0.19> {};
struct RightHind : on<RightHind, Rear, A, -0.09, -0.055, -0.19> {};
struct LeftShoulder : on<LeftShoulder, Front, B, 0.05, 0.045, -0.02> {};
struct RightShoulder : on<RightShoulder, Front, B, 0.05, -0.045, -0.02> {};
struct LeftFore : on<LeftFore, Front, B, 0.07, 0.055, -0.19> {};
struct RightFore : on<RightFore, Front, B, 0.07, -0.055, -0.19> {};

using fur = colour<"#d98a2b">;
using white = colour<"#efe6d8">;
using dark = colour<"#4b5563">;

using picture =
    kanexpr::picture<System, up<N::z>, ground<>, seen_from<N::x - 1.7 * N::y + 0.35 * N::z>,
                     show<rod<RearEnd, Waist, 0.06>, fur>, show<rod<Waist, FrontEnd, 0.06>, fur>,
                     show<sphere<Waist, 0.06>, fur>, show<sphere<Head, 0.055>, fur>,
                     show<sphere<Nose, 0.016>, dark>, show<sphere<LeftEar, 0.018>, dark>,
                     show<sphere<RightEar, 0.018>, dark>, show<rod<RearEnd, TailTip, 0.013>, fur>,
                     show<rod<LeftHip, LeftHind, 0.02>, fur>, show<rod<RightHip, RightHind, 0.02>, fur>,
                     show<rod<LeftShoulder, LeftFore, 0.02>, fur>,
                     show<rod<RightShoulder, RightFore, 0.02>, fur>, show<sphere<LeftHind, 0.024>, white>,
                     show<sphere<RightHind, 0.024>, white>, show<sphere<LeftFore, 0.024>, white>,
                     show<sphere<RightFore, 0.024>, white>>;

/// From 0 to 1 between two times, with vanishing first and second derivatives at both.
template <class Time>
Time step(Time t, double from, double to) {
  const Time s = (t - from) / (to - from);
  if (s <= 0.0) return s * 0.0;
  if (s >= 1.0) return s * 0.0 + 1.0;
  return s * s * s * (10.0 - s * (15.0 - 6.0 * s));
}

constexpr double begins = 0.1, bent = 0.2, unbends = 0.45, ends = 0.55, lands = 0.6; // s

inline simulation<System> fall(double bend) {
  const double height = 0.2 + 9.81 * lands * lands / 2;
  return simulate<System>({{x, 0},
                           {y, 0},
                           {z, height},
                           {e1, 1},
                           {e2, 0},
                           {e3, 0},
                           {e0, 0},
                           {v1, 0},
                           {v2, 0},
                           {v3, 0},
                           {w1, 0},
                           {w2, 0},
                           {w3, 0}},
                          {{m, 1.7}, {h, 0.12}, {I, 0.0033}, {J, 0.012}, {g, 9.81}}, {0, lands},
                          {.inputs =
                               [bend](double t, const state<System>&, input_values<System>& r) {
                                 prescribe(r, beta, t, [bend](auto time) {
                                   return bend * (step(time, begins, bent) - step(time, unbends, ends));
                                 });
                                 prescribe(r, psi, t, [](auto time) {
                                   return 2 * std::numbers::pi * step(time, bent - 0.05, unbends + 0.05);
                                 });
                               },
                           .relative_tolerance = 1e-10,
                           .output_every = 0.005});
}

/// The height of the back above the belly: −1 upside down, 1 on the feet.
inline double upright(const simulation<System>& run) {
  return 1 - 2 * (run.state[e1] * run.state[e1] + run.state[e2] * run.state[e2]);
}

} // namespace falling_cat

int main(int count, char** words) {
  using namespace falling_cat;
  gallery::page page(
      count, words,
      {.title = "Falling cat",
       .kind = "Gyroscopes",
       .see =
           "The cat is dropped upside down, bends at the waist, lets the bend go around its body and lands "
           "on its feet. Its "
           "angular momentum is zero from the beginning to the end: the change of shape alone turns it over.",
       .source = "Kane & Scher, A dynamical explanation of the falling cat phenomenon, International Journal "
                 "of Solids and "
                 "Structures 5 (1969), pages 663-670"});
  double best = 0, most = -2; // the bend that turns the cat over best
  for (double bend = 0.9; bend < 1.5; bend += 0.05)
    if (const double now = upright(fall(bend)); now > most) most = now, best = bend;
  const auto run = fall(best);
  std::printf("bend %g rad, upright %g\n", best, most);
  page.expect(upright(run) > 0.98, "the cat lands on its feet");
  double largest = 0;
  for (const Eigen::Vector3d& each : run.trajectory.along<momentum>())
    largest = std::max(largest, each.norm());
  page.expect_small("the angular momentum about the mass center is zero",
                    largest / (2 * 0.012 * 2 * std::numbers::pi / lands), 1e-6);
  return page.show<falling_cat::picture>(run, {.at = 0.25});
}
