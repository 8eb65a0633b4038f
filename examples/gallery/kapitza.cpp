// A pendulum whose pivot vibrates fast stands upright.
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/prescribe.hpp>
#include <parts/page.hpp>

namespace kapitza {

using namespace kanexpr;
using namespace kanexpr::units::si;

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

struct Foot : offset<Foot, O, -0.12 * N::y> {};

using picture =
    kanexpr::picture<System, up<N::y>, seen_from<N::z + 0.3 * N::x + 0.15 * N::y>,
                     trace<P, colour<"#d98a2b">>, show<box<N, Pivot, 0.06, 0.03, 0.06>, colour<"#8f979e">>,
                     show<rod<Foot, Pivot, 0.008>, colour<"#8f979e">>,
                     show<rod<Pivot, P, 0.006>, colour<"#3d6b99">>, show<sphere<P, 0.02>, colour<"#b5382f">>>;

} // namespace kapitza

int main(int count, char** words) {
  using namespace kapitza;
  gallery::page page(
      count, words,
      {.title = "Kapitza's pendulum",
       .kind = "Pendulums",
       .see = "The pivot vibrates by 2 cm, thirty times a second, and the pendulum stands upside down and "
              "sways like a hanging one. It stands because the square of the pivot's speed, averaged over "
              "time, exceeds 2 g l.",
       .source = "Kapitza, Dynamic stability of a pendulum when its point of suspension vibrates (1951), "
                 "in Collected Papers, volume 2; Landau & Lifshitz, Mechanics, section 30"});
  const double amplitude = 0.02, rate = 2 * std::numbers::pi * 30, length = 0.2;
  const auto run = simulate<System>({{theta, std::numbers::pi - 0.4}, {u, 0}},
                                    {{m, 0.1}, {l, length}, {g, 9.81}, {c, 4e-4}}, {0, 6},
                                    {.inputs =
                                         [&](double t, const state<System>&, input_values<System>& r) {
                                           prescribe(r, y, t, [&](auto time) {
                                             using std::cos;
                                             return amplitude * cos(rate * time);
                                           });
                                         },
                                     .relative_tolerance = 1e-9,
                                     .output_every = 1 / 240.0});
  page.expect(amplitude * amplitude * rate * rate > 2 * 9.81 * length, "a² ω² exceeds 2 g l");
  double most = 0;
  for (const double angle : run.trajectory[theta]) most = std::max(most, std::abs(angle - std::numbers::pi));
  page.expect(most < 0.6, "the pendulum stays within 0.6 rad of the upright position");
  return page.show<kapitza::picture>(run);
}
