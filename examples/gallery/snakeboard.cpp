// A rider moves a board by twisting, without touching the ground.
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/prescribe.hpp>
#include <parts/page.hpp>

namespace snakeboard {

using namespace kanexpr;
using namespace kanexpr::units::si;

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

struct Hips : offset<Hips, G, 0.35 * A::z> {};
struct Left : offset<Left, Hips, 0.3 * B::y> {};
struct Right : offset<Right, Hips, -0.3 * B::y> {};
template <class Self, class From, class Frame, auto side>
struct wheel_at : offset<Self, From, double(side) * 0.11 * Frame::y> {};
struct FL : wheel_at<FL, Front, F, 1> {};
struct FR : wheel_at<FR, Front, F, -1> {};
struct RL : wheel_at<RL, Rear, R, 1> {};
struct RR : wheel_at<RR, Rear, R, -1> {};

template <class P, class Frame>
using tire = show<cylinder<Frame, P, Frame::y, 0.05, 0.03>, colour<"#33383d">>;

using picture =
    kanexpr::picture<System, up<N::z>, ground<-0.05>, seen_from<N::x - 1.3 * N::y + 1.1 * N::z>,
                     trace<G, colour<"#d98a2b">>, show<rod<Rear, Front, 0.035>, colour<"#3d6b99">>,
                     show<rod<FL, FR, 0.02>, colour<"#8f979e">>, show<rod<RL, RR, 0.02>, colour<"#8f979e">>,
                     tire<FL, F>, tire<FR, F>, tire<RL, R>, tire<RR, R>,
                     show<rod<G, Hips, 0.04>, colour<"#4b5563">>,
                     show<rod<Left, Right, 0.03>, colour<"#b5382f">, named<"rider">>>;

} // namespace snakeboard

int main(int count, char** words) {
  using namespace snakeboard;
  gallery::page page(count, words,
                     {.title = "Snakeboard",
                      .kind = "Vehicles",
                      .see = "The rider twists the body and both pairs of wheels in the same rhythm, and the "
                             "board winds ahead faster "
                             "and faster. No foot touches the ground: the constraints of the wheels turn the "
                             "twist into momentum.",
                      .source = "Ostrowski, Lewis, Murray & Burdick, Nonholonomic mechanics and locomotion: "
                                "the snakeboard example, "
                                "IEEE International Conference on Robotics and Automation (1994)"});
  const auto run = simulate<System>(
      {{x, 0}, {y, 0}, {theta, 0}, {u1, 0}}, {{m, 6}, {l, 0.2}, {J, 0.06}, {Jr, 0.16}, {Jw, 0.002}}, {0, 8},
      {.inputs =
           [](double t, const state<System>&, input_values<System>& r) {
             using std::sin;
             prescribe(r, psi, t, [](auto time) { return 0.7 * sin(2.8 * time); });
             prescribe(r, phi, t, [](auto time) { return 0.3 * sin(2.8 * time); });
           },
       .relative_tolerance = 1e-9,
       .output_every = 0.02});
  page.expect_constraints(run.trajectory, 1e-8);
  std::printf("goes to %g %g at %g\n", run.state[x], run.state[y], run.state[u1]);
  page.expect(run.state[x] > 1.5, "the board travels ahead by more than 1.5 m");
  return page.show<snakeboard::picture>(run, {.at = 0.4});
}
