// A bob on a rod that may swing in any direction.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace spherical_pendulum {

using namespace kanexpr;
using namespace kanexpr::units::si;

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

constexpr auto spin = m * dot(cross(position_of<P, O>, velocity_of<P>), N::z);

using picture = kanexpr::picture<System, up<N::z>, seen_from<N::x - 1.4 * N::y + 1.1 * N::z>,
                                 trace<P, colour<"#d98a2b">>, show<sphere<O, 0.03 * l>, colour<"#8f979e">>,
                                 show<rod<O, P, 0.012 * l>, colour<"#3d6b99">>,
                                 show<sphere<P, 0.08 * l>, colour<"#b5382f">>>;

} // namespace spherical_pendulum

int main(int count, char** words) {
  using namespace spherical_pendulum;
  gallery::page page(
      count, words,
      {.title = "Spherical pendulum",
       .kind = "Pendulums",
       .see = "The bob swings between two heights and never passes through the lowest point. Its path "
              "is a rosette: the highest point advances by a little more than half a turn each time.",
       .source = "Whittaker, A Treatise on the Analytical Dynamics of Particles and Rigid Bodies, 4th "
                 "edition (1937), section 55"});
  const auto run = simulate<System>({{theta, 1.2}, {phi, 0}, {u1, 0}, {u2, 0.8}}, {{m, 1}, {l, 1}, {g, 9.81}},
                                    {0, 20}, {.relative_tolerance = 1e-11, .output_every = 0.02});
  page.expect_energy(run.trajectory, 1e-8);
  const std::vector<double> spins = run.trajectory.along<spin>();
  page.expect_constant("the angular momentum about the vertical", spins, spins.front(), 1e-8);
  return page.show<spherical_pendulum::picture>(run, {.at = 0.3});
}
