// A gust hits a wind turbine: the blades bend, and the tower swings.
#include <kanexpr/animate/bent.hpp>
#include <kanexpr/beams.hpp>
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace wind_turbine {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"psi", radian> psi; // azimuth of the rotor
constexpr speed<"omega"> omega;          // speed of the rotor
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"c", newton * second / meter> c; // thrust on a blade per speed of the air
constexpr parameter<"zeta", dimensionless> zeta;     // ratio of structural damping
constexpr input<"w", meter / second> w;              // speed of the wind
constexpr input<"T", newton * meter> T;              // torque on the rotor, of the air minus the generator's

struct N : inertial_frame<N> {}; // x downwind, z up
struct O : origin<O, N> {};

// The tower bends fore-aft and sideways; shapes, masses and stiffnesses at its stations are those of a 5 MW
// turbine.
using tower_shape = polynomial<0, 0, 0.7004, 2.1963, -5.6202, 6.2275, -2.5040>;
using tower_stiffness = profile<stations<0, 1, 0.2, 0.754, 0.4, 0.557, 0.6, 0.4, 0.8, 0.28, 1, 0.1885>>;
struct Tower : beam<Tower, O, N::z, 87.6, 5590.9, profile<stations<0, 1, 0.5, 0.7005, 1, 0.4537>>,
                    bending<N::x, 6.143e11, tower_shape, tower_stiffness>,
                    bending<N::y, 6.143e11, tower_shape, tower_stiffness>, modal_damping<zeta>> {};
struct Top : section<Top, Tower, 1> {};
struct Nacelle_center : offset<Nacelle_center, Top, 1.9 * Top::x + 1.75 * Top::z> {};
struct Nacelle : rigid_body<Nacelle, Nacelle_center, Top, 240000, inertia<Top, 4.5e5, 2.6e6, 2.6e6>> {};

// The rotor turns upwind of the tower.
struct Shaft : offset<Shaft, Top, -5.0 * Top::x + 2.4 * Top::z> {};
struct Rotor : rotated<Rotor, Top, psi, Top::x> {};
struct Hub : rigid_body<Hub, Shaft, Rotor, 56780, inertia<Rotor, 1.16e5, 1e5, 1e5>> {};

template <int k>
struct Azimuth : rotated<Azimuth<k>, Rotor, (k - 1) * 2 * std::numbers::pi / 3, Rotor::x> {};
template <int k> // x points to the trailing edge, y upwind
struct Axes : rotated<Axes<k>, Azimuth<k>, std::numbers::pi / 2, Azimuth<k>::z> {};
template <int k>
struct Root : offset<Root<k>, Shaft, 1.5 * Axes<k>::z> {};
template <int k>
struct Blade : beam<Blade<k>, Root<k>, Axes<k>::z, 61.5, 680.0,
                    profile<stations<0, 1, 0.1, 0.62, 0.2, 0.6, 0.4, 0.5, 0.6, 0.36, 0.8, 0.2, 1, 0.02>>,
                    bending<-Axes<k>::y, 1.81e10, polynomial<0, 0, 0.0622, 1.7254, -3.2452, 4.7131, -2.2555>,
                            profile<stations<0, 1, 0.1, 0.33, 0.2, 0.15, 0.3, 0.11, 0.5, 0.03, 0.7, 0.008,
                                             0.85, 0.0022, 1, 0.0001>>>,
                    modal_damping<zeta>> {};
template <int k>
struct Outer : section<Outer<k>, Blade<k>, 0.7> {};

/// The thrust on a blade: in proportion to the speed of the air that passes it.
template <int k>
struct thrust : force<Outer<k>, c*(w - dot(velocity_of<Outer<k>>, Rotor::x)) * Rotor::x> {};

struct System
    : kane_system<inertial<N>, coordinates<psi>, speeds<omega>, kinematics<simple>, inputs<w, T>,
                  bodies<Tower, Nacelle, Hub, Blade<1>, Blade<2>, Blade<3>>,
                  loads<gravity<-g * N::z>, thrust<1>, thrust<2>, thrust<3>, torque<Rotor, T * Rotor::x>>> {};

using nacelle_shape = box<Top, Nacelle_center, 14, 4.5, 4.5>;
template <int k>
using blade_shape = bent<Blade<k>, tapered<airfoil<4.6, 1.4>, airfoil<1.2, 0.25>>>;
using picture =
    kanexpr::picture<System, up<N::z>, ground<0.0>, seen_from<-1.2 * N::x - N::y + 0.25 * N::z>,
                     show<bent<Tower, tapered<circle<3.0>, circle<1.94>>>, colour<"#cfd6dc">>,
                     show<nacelle_shape, colour<"#cfd6dc">, named<"nacelle">>,
                     show<sphere<Shaft, 2.2>, colour<"#8f979e">, named<"hub">>,
                     show<blade_shape<1>, colour<"#3d6b99">>, show<blade_shape<2>, colour<"#3d6b99">>,
                     show<blade_shape<3>, colour<"#3d6b99">>, trace<Top, colour<"#d98a2b">>>;

/// The speed of the wind, with a gust between 20 and 30 seconds.
inline double wind_at(double t) {
  if (t < 20 || t > 30) return 11;
  return 11 + 4 * (1 - std::cos(2 * std::numbers::pi * (t - 20) / 10));
}

} // namespace wind_turbine

int main(int count, char** words) {
  using namespace wind_turbine;
  gallery::page page(
      count, words,
      {.title = "Wind turbine",
       .kind = "Flexible bodies",
       .see = "A steady wind bends the blades and the tower, and a gust bends them farther. Afterwards, "
              "the tower swings slowly, damped mainly by the air that passes the blades.",
       .source = "Branlard & Geisler, A symbolic framework to obtain mid-fidelity models of flexible "
                 "multibody systems with application to horizontal-axis wind turbines, Wind Energy "
                 "Science 7 (2022), pages 2351-2371; numbers after Jonkman et al. (2009)"});
  simulation_options<System> how{.output_every = 0.05};
  how.inputs = [](double t, const state<System>& x, input_values<System>& r) {
    r[w] = wind_at(t);
    r[T] = 4e7 * (1.2 - x[omega]); // keeps the speed
  };
  state<System> start = state<System>::Zero();
  start[omega] = 1.2;
  const auto run = simulate<System>(start, {{g, 9.81}, {c, 1.4e4}, {zeta, 0.01}}, {0, 60}, how);
  double before = 0, most = 0, last = 0, flap = 0;
  for (std::size_t i = 0; i < run.trajectory.size(); ++i) {
    const auto& now = run.trajectory[i];
    const double top = now.x[q_of<Tower, 1>];
    if (now.t < 20) before = top;
    most = std::max(most, top), last = top, flap = std::max(flap, now.x[q_of<Blade<1>, 1>]);
  }
  std::printf("the tower leans %g, %g in the gust, %g at the end; flap %g\n", before, most, last, flap);
  page.expect(most > before + 0.1, "the gust bends the tower farther");
  page.expect(std::abs(last - before) < 0.05, "the tower comes back to where it was");
  page.expect(flap > 1, "the blades bend by meters");

  simulation_options<System> freely{.output_every = 0.05};
  freely.inputs = input_values<System>::Zero();
  const auto coasting = simulate<System>(start, {{g, 9.81}, {c, 0}, {zeta, 0}}, {0, 20}, freely);
  page.expect_energy(coasting.trajectory, 1e-6); // without air, generator and damping
  return page.show<wind_turbine::picture>(run, {.at = 25});
}
