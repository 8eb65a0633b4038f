// A drone that a spring draws to a post flies with constant speed.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace constant_speed {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"z", meter> z;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"k", newton / meter> k;
constexpr parameter<"c", meter / second> c;

struct N : inertial_frame<N> {}; // z points up

struct O : origin<O, N> {};
struct Foot : offset<Foot, O, -0.8 * N::z> {};
struct P : offset<P, O, x * N::x + y * N::y + z * N::z> {};
struct Drone : particle<Drone, P, m> {};

constexpr auto r = position_of<P, O>;
constexpr auto v = velocity_of<P>;

struct System : kane_system<inertial<N>, coordinates<x, y, z>, speeds<u1, u2, u3>, kinematics<simple>,
                            velocity_constraints<dot(v, v) == c * c>, parameters<m, k, c>, bodies<Drone>,
                            loads<potential_energy<k * dot(r, r) / 2>>> {};

// Bouguer's invariant of a ray of light: the index of refraction times the distance of the ray from the
// center.
constexpr auto ray = magnitude(cross(r, v)) * exp(-k * dot(r, r) / (2 * m * c * c));

using picture =
    kanexpr::picture<System, up<N::z>, ground<-0.8>, seen_from<N::x - 1.4 * N::y + 1.2 * N::z>,
                     trace<P, colour<"#d98a2b">>, show<rod<Foot, O, 0.03>, colour<"#8f979e">>,
                     show<coil<O, P, 0.02, 20>, colour<"#3d6b99">>, show<sphere<P, 0.06>, colour<"#b5382f">>>;

} // namespace constant_speed

int main(int count, char** words) {
  using namespace constant_speed;
  gallery::page page(
      count, words,
      {.title = "Constant speed",
       .kind = "Vehicles",
       .see = "The spring turns the velocity but does not change its magnitude, because the controller that "
              "keeps the "
              "speed pushes along the velocity: the constraint is not linear in the speeds. The path, a "
              "rosette, is "
              "that of a ray of light in a lens with the refractive index exp(−V/(m c²)), where V is the "
              "energy of "
              "the spring.",
       .source =
           "Neimark & Fufaev, Dynamics of Nonholonomic Systems (1972), chapter 4; for the ray, Born & Wolf, "
           "Principles of Optics (1999), section 3.2"});
  const auto run = simulate<System>(
      {{x, 0.9}, {y, 0}, {z, 0}, {u1, 0}, {u2, 0.9}, {u3, 1.2}}, {{m, 0.5}, {k, 2}, {c, 1.5}}, {0, 20},
      {.guesses_dependent = true, .relative_tolerance = 1e-10, .output_every = 0.02});
  page.expect_constraints(run.trajectory, 1e-10);
  const auto rays = run.trajectory.along<ray>(); // each with a status
  page.expect_constant("the invariant of the ray", {rays.begin(), rays.end()}, rays.front(), 1e-8);
  return page.show<constant_speed::picture>(run, {.at = 1.2});
}
