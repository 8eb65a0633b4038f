// A toy that goes ahead when its handlebars wiggle.
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/prescribe.hpp>
#include <parts/page.hpp>

namespace roller_racer {

using namespace kanexpr;
using namespace kanexpr::units::si;

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

struct RL : offset<RL, Rear, 0.22 * A::y> {};
struct RR : offset<RR, Rear, -0.22 * A::y> {};
struct FL : offset<FL, Front, 0.08 * B::y> {};
struct FR : offset<FR, Front, -0.08 * B::y> {};
struct Top : offset<Top, P, 0.3 * N::z> {};
struct TL : offset<TL, Top, 0.2 * B::y> {};
struct TR : offset<TR, Top, -0.2 * B::y> {};
struct Plate : offset<Plate, Rear, 0.05 * N::z> {};

template <class Point, class Frame>
using tire = show<cylinder<Frame, Point, Frame::y, 0.05, 0.03>, colour<"#33383d">>;

using picture = kanexpr::picture<
    System, up<N::z>, ground<-0.05>, seen_from<N::x - 1.3 * N::y + 1.1 * N::z>, trace<P, colour<"#d98a2b">>,
    show<box<A, Plate, 0.28, 0.3, 0.04>, colour<"#b5382f">, named<"seat">>,
    show<rod<Rear, P, 0.025>, colour<"#b5382f">>, show<rod<P, Front, 0.02>, colour<"#3d6b99">>,
    show<rod<P, Top, 0.015>, colour<"#3d6b99">>, show<rod<TL, TR, 0.015>, colour<"#3d6b99">>,
    show<rod<RL, RR, 0.012>, colour<"#8f979e">>, show<rod<FL, FR, 0.012>, colour<"#8f979e">>, tire<RL, A>,
    tire<RR, A>, tire<FL, B>, tire<FR, B>>;

} // namespace roller_racer

int main(int count, char** words) {
  using namespace roller_racer;
  gallery::page page(count, words,
                     {.title = "Roller racer",
                      .kind = "Vehicles",
                      .see = "The handlebars swing from side to side, and the toy goes ahead although no "
                             "wheel is driven. The wheels do "
                             "not slip sideways, so each swing pushes against the ground.",
                      .source = "Krishnaprasad & Tsakiris, Oscillations, SE(2)-snakes and motion control: a "
                                "study of the roller racer, "
                                "Dynamical Systems 16 (2001), pages 347-397"});
  const auto run =
      simulate<System>({{x, 0}, {y, 0}, {theta, 0}, {u1, 0}},
                       {{m1, 20}, {m2, 1.5}, {I1, 0.8}, {I2, 0.08}, {d1, 0.35}, {d2, -0.05}}, {0, 7},
                       {.inputs =
                            [](double t, const state<System>&, input_values<System>& r) {
                              using std::sin;
                              prescribe(r, beta, t, [](auto time) { return 0.6 * sin(4 * time); });
                            },
                        .relative_tolerance = 1e-9,
                        .output_every = 0.02});
  page.expect_constraints(run.trajectory, 1e-8);
  std::printf("goes to %g %g at %g\n", run.state[x], run.state[y], run.state[u1]);
  page.expect(run.state[x] > 1, "the toy travels ahead by more than a meter");
  return page.show<roller_racer::picture>(run, {.at = 0.1});
}
