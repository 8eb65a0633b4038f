// A ball rolls on a turntable, in a circle that has nothing to do with the table's center.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace turntable {

using namespace kanexpr;
using namespace kanexpr::units::si;

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

struct Below : offset<Below, O, -0.02 * N::z> {};
struct Mark : offset<Mark, O, 0.7 * T::x + 0.004 * N::z> {};
struct Hub : offset<Hub, O, 0.004 * N::z> {};

using picture =
    kanexpr::picture<System, up<N::z>, seen_from<N::x - 1.2 * N::y + 1.5 * N::z>, trace<G, colour<"#d98a2b">>,
                     show<cylinder<T, Below, T::z, 1, 0.04>, colour<"#7b8794">>,
                     show<rod<Hub, Mark, 0.012>, colour<"#e0b25a">>, show<sphere<G, r>, colour<"#b5382f">>>;

} // namespace turntable

int main(int count, char** words) {
  using namespace turntable;
  gallery::page page(
      count, words,
      {.title = "Ball on a turntable",
       .kind = "Rolling",
       .see = "The ball rolls without slipping and moves in a circle, two turns for every seven of the "
              "table. The circle "
              "neither grows nor drifts to the rim; where it lies depends only on how the ball was released.",
       .source = "Earnshaw, Dynamics, 3rd edition (1844); Burns, Ball rolling on a turntable: analog for "
                 "charged particle "
                 "dynamics, American Journal of Physics 49 (1981), pages 56-58"});
  const double rate = 7;
  const auto run = simulate<System>({{x, 0.35}, {y, 0}, {phi, 0}, {v1, 0.2}, {v2, 0.5}, {w3, 0}},
                                    {{Omega, rate}, {m, 0.2}, {r, 0.06}}, {0, 10},
                                    {.relative_tolerance = 1e-10, .output_every = 0.01});
  page.expect_constraints(run.trajectory, 1e-9);
  // The velocity turns at 2/7 of the table's rate.
  const double turned = 2 * rate / 7 * run.time, c = std::cos(turned), s = std::sin(turned);
  page.expect_small("the velocity turns at 2/7 of the table's rate",
                    std::hypot(run.state[v1] - (0.2 * c - 0.5 * s), run.state[v2] - (0.2 * s + 0.5 * c)),
                    1e-6);
  return page.show<turntable::picture>(run);
}
