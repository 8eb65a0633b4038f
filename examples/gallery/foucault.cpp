// A long pendulum on the turning Earth, in the axes of the laboratory.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace foucault {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x; // east
constexpr coordinate<"y", meter> y; // north
constexpr coordinate<"z", meter> z;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"Omega", radian / second> Omega; // of the Earth
constexpr parameter<"lambda", radian> lambda;        // latitude

struct N : inertial_frame<N> {}; // east, north, up: the Coriolis force stands for the Earth's rotation
struct O : origin<O, N> {};      // the suspension
struct P : offset<P, O, x * N::x + y * N::y + z * N::z> {};
struct Bob : particle<Bob, P, m> {};

constexpr auto earth = Omega * (cos(lambda) * N::y + sin(lambda) * N::z);
constexpr auto coriolis = -2 * m * cross(earth, velocity_of<P>);

struct System : kane_system<inertial<N>, coordinates<x, y, z>, speeds<u1, u2, u3>, kinematics<simple>,
                            configuration_constraints<x * x + y * y + z * z == l * l>, dependent<z, u3>,
                            parameters<m, l, g, Omega, lambda>, bodies<Bob>,
                            loads<gravity<-g * N::z>, force<P, coriolis>>> {};

using picture =
    kanexpr::picture<System, up<N::z>, ground<-1.02 * l>, seen_from<N::x - 1.2 * N::y + 0.6 * N::z>,
                     trace<P, colour<"#d98a2b">>, show<rod<O, P, 0.02>, colour<"#7b8794">>,
                     show<sphere<O, 0.3>, colour<"#8f979e">>, show<sphere<P, 1.2>, colour<"#b5382f">>>;

} // namespace foucault

int main(int count, char** words) {
  using namespace foucault;
  gallery::page page(
      count, words,
      {.title = "Foucault's pendulum",
       .kind = "Gyroscopes",
       .see = "The plane of the swing turns clockwise, as in the Panthéon in Paris. The Earth of this page "
              "turns a hundred times too fast, so that two minutes show what takes three hours and a half "
              "there.",
       .source = "Foucault, Comptes rendus 32 (1851), page 135; Goldstein, Poole & Safko, Classical "
                 "Mechanics (2002), section 4.10"});
  const double earth_rate = 100 * 7.292e-5, latitude = 48.85 * std::numbers::pi / 180, length = 67;
  const double swing = 12; // m
  const double height = -std::sqrt(length * length - swing * swing);
  const auto run =
      simulate<System>({{x, 0}, {y, swing}, {z, height}, {u1, 0}, {u2, 0}},
                       {{m, 28}, {l, length}, {g, 9.81}, {Omega, earth_rate}, {lambda, latitude}}, {0, 131.6},
                       {.relative_tolerance = 1e-10, .output_every = 0.1});
  page.expect_energy(run.trajectory, 1e-6);
  page.expect_constraints(run.trajectory, 1e-6);
  // The plane turns by −Omega sin(lambda) t. The pendulum is farthest out where its distance is largest.
  double farthest = 0, angle = 0, when = 0;
  for (const auto& s : run.trajectory)
    if (s.t > 110 && std::hypot(s.x[x], s.x[y]) > farthest)
      farthest = std::hypot(s.x[x], s.x[y]), angle = std::atan(s.x[x] / s.x[y]), when = s.t;
  page.expect_small("the plane of the swing turns by Ω sin λ",
                    std::abs(angle / (earth_rate * std::sin(latitude) * when) - 1), 0.03);
  return page.show<foucault::picture>(run);
}
