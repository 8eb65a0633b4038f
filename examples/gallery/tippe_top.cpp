// A top with a low mass center turns over and spins on its stem.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace tippe_top {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"e1"> e1; // the orientation, a unit quaternion
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr speed<"v1"> v1; // of the sphere's center
constexpr speed<"v2"> v2;
constexpr speed<"w1"> w1; // angular velocity, in the axes of the top
constexpr speed<"w2"> w2;
constexpr speed<"w3"> w3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"R", meter> R;                    // radius of the sphere
constexpr parameter<"a", meter> a;                    // from its center down to the mass center
constexpr parameter<"A", kilogram * pow<2>(meter)> A; // moment of inertia across the stem
constexpr parameter<"C", kilogram * pow<2>(meter)> C; // and about it
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"mu", dimensionless> mu;
constexpr parameter<"s", meter / second> s; // the sliding speed below which friction becomes viscous

struct N : inertial_frame<N> {}; // z points up
struct B : quaternion<B, N, e0, e1, e2, e3>, angular_velocity<N, w1 * own::x + w2 * own::y + w3 * own::z> {};
struct O : origin<O, N> {};
struct S : offset<S, O, x * N::x + y * N::y + R * N::z>, velocity<N, v1 * N::x + v2 * N::y> {};
struct G : offset<G, S, -a * B::z> {};
struct P : offset<P, S, -R * N::z>, fixed_in<B> {}; // the point that slides on the table

// Coulomb friction under the weight, smooth where the sliding stops.
constexpr auto sliding = velocity_of<P>;
constexpr auto friction =
    -mu * m * g /
    sqrt(dot(sliding, N::x) * dot(sliding, N::x) + dot(sliding, N::y) * dot(sliding, N::y) + s * s) * sliding;

struct Top : rigid_body<Top, G, B, m, inertia<B, A, A, C>> {};

struct System : kane_system<inertial<N>, coordinates<x, y, e1, e2, e3, e0>, speeds<v1, v2, w1, w2, w3>,
                            kinematics<dot(x) == v1, dot(y) == v2, kinematics_of<B, N>>,
                            parameters<m, R, a, A, C, g, mu, s>, bodies<Top>,
                            loads<gravity<-g * N::z>, force<P, friction>>> {};

// Jellett's invariant: no force at the contact changes it.
constexpr auto jellett = -dot(A * w1 * B::x + A * w2 * B::y + C * w3 * B::z, -R* N::z + a * B::z);

struct Stem : offset<Stem, S, 0.95 * R * B::z> {};
struct Tip : offset<Tip, S, 1.75 * R * B::z> {};

using picture = kanexpr::picture<System, up<N::z>, ground<>, seen_from<N::x - 1.6 * N::y + 0.9 * N::z>,
                                 trace<P, colour<"#9fb4c8">>, show<sphere<S, R>, colour<"#b5382f">>,
                                 show<rod<Stem, Tip, 0.22 * R>, colour<"#e0b25a">>,
                                 show<sphere<Tip, 0.26 * R>, colour<"#e0b25a">>>;

} // namespace tippe_top

int main(int count, char** words) {
  using namespace tippe_top;
  gallery::page page(
      count, words,
      {.title = "Tippe top",
       .kind = "Gyroscopes",
       .see = "The top is spun on its round side, leans over and rises onto its stem. Sliding friction at "
              "the contact lifts the mass center; the spin becomes slower and, seen from the top, "
              "reverses its sense.",
       .source = "Cohen, The tippe top revisited, American Journal of Physics 45 (1977), pages 12-17; "
                 "Gray & Nickel, Constants of the motion for nonslipping tippe tops, American Journal "
                 "of Physics 68 (2000), pages 821-828"});
  const double tilt = 0.1, mass = 0.02, radius = 0.02, spin = 155;
  const auto run = simulate<System>({{x, 0},
                                     {y, 0},
                                     {e1, std::sin(tilt / 2)},
                                     {e2, 0},
                                     {e3, 0},
                                     {e0, std::cos(tilt / 2)},
                                     {v1, 0},
                                     {v2, 0},
                                     {w1, 0},
                                     {w2, 0},
                                     {w3, spin}},
                                    {{m, mass},
                                     {R, radius},
                                     {a, 0.3 * radius},
                                     {A, 131.0 / 350 * mass * radius * radius},
                                     {C, 0.4 * mass * radius * radius},
                                     {g, 9.81},
                                     {mu, 0.3},
                                     {s, 0.01}},
                                    {0, 6}, {.relative_tolerance = 1e-9, .output_every = 0.01});
  const auto invariant = run.trajectory.along<jellett>();
  page.expect_constant("Jellett's invariant", invariant, invariant.front(), 1e-5);
  const auto height = run.trajectory.along<dot(B::z, N::z)>();
  std::printf("axis %g to %g\n", height.front(), height.back());
  page.expect(height.front() > 0.99 && height.back() < -0.95, "the top turns upside down");
  const auto energy = run.trajectory.energies().total;
  page.expect(energy.back() < energy.front(), "friction takes energy");
  return page.show<tippe_top::picture>(run, {.at = 1.5});
}
