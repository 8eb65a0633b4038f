// A rotor whose axis is kept level finds north.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace gyrocompass {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"alpha", radian> alpha; // from north to the axis of the rotor, toward west
constexpr speed<"u"> u;
constexpr speed<"s", radian / second> s;             // spin of the rotor relative to its gimbal
constexpr parameter<"Omega", radian / second> Omega; // of the Earth
constexpr parameter<"lambda", radian> lambda;        // latitude
constexpr parameter<"m", kilogram> m;
constexpr parameter<"A", kilogram * pow<2>(meter)> A; // moment of inertia of the rotor across its axis
constexpr parameter<"C", kilogram * pow<2>(meter)> C; // and about it
constexpr parameter<"c", newton * meter * second / radian> c; // damping of the gimbal
constexpr time_variable t;

struct N : inertial_frame<N> {};                                                 // at t = 0: east, north, up
struct E : rotated<E, N, Omega * t, cos(lambda) * N::y + sin(lambda) * N::z> {}; // the Earth
struct F : rotated<F, E, alpha, E::z> {};                                        // the gimbal, level
struct R : rotated<R, F, 0, F::y>, angular_velocity<F, s * F::y> {};             // the rotor
struct O : origin<O, N> {};
struct Rotor : rigid_body<Rotor, O, R, m, inertia<F, A, C, A>> {};

struct System : kane_system<inertial<N>, coordinates<alpha>, speeds<u, s>, kinematics<dot(alpha) == u>,
                            parameters<Omega, lambda, m, A, C, c>, bodies<Rotor>,
                            loads<torque_between<F, E, -c * u * F::z>>> {};

struct Ahead : offset<Ahead, O, 0.16 * F::y> {};
struct Behind : offset<Behind, O, -0.12 * F::y> {};
struct Under : offset<Under, O, -0.13 * E::z> {};
struct North : offset<North, Under, 0.2 * E::y> {};

using picture = kanexpr::picture<System, up<N::z>, ground<-0.13>, seen_from<0.7 * N::x - N::y + 0.9 * N::z>,
                                 show<wheel<R, O, F::y, 0.08, 0.03>, spinning<s / 500>, colour<"#8f979e">>,
                                 show<ring<F, O, F::x, 0.1, 0.012>, colour<"#e0b25a">>,
                                 show<rod<Behind, Ahead, 0.006>, colour<"#3d6b99">>,
                                 show<cone<F, Ahead, -F::y, 0.012, 0.04>, colour<"#b5382f">>,
                                 show<rod<Under, North, 0.004>, colour<"#5d8a4a">, named<"north">>>;

} // namespace gyrocompass

int main(int count, char** words) {
  using namespace gyrocompass;
  gallery::page page(
      count, words,
      {.title = "Gyrocompass",
       .kind = "Gyroscopes",
       .see = "The axis of the rotor starts 70 degrees from north, swings about north and comes to rest "
              "there. Only the rotation of "
              "the Earth, at its true rate, turns it to north, and a damper ends the swing; the picture "
              "shows the spin five hundred times too slow.",
       .source = "Arnold & Maunder, Gyrodynamics and Its Engineering Applications (1961), chapter 9"});
  const double earth = 7.292e-5, latitude = 0.8, across = 6e-3, about = 1e-2, spin = 2500;
  const auto simulated = [&](double angle, double damping, double seconds,
                             std::vector<event<System>> events) {
    return simulate<System>(
        {{alpha, angle}, {u, 0}, {s, spin}},
        {{Omega, earth}, {lambda, latitude}, {m, 2}, {A, across}, {C, about}, {c, damping}}, {0, seconds},
        {.relative_tolerance = 1e-10, .output_every = 0.05, .events = std::move(events)});
  };
  const auto run = simulated(1.2, 1.2e-3, 60, {});
  std::printf("last %g\n", run.state[alpha]);
  page.expect(std::abs(run.state[alpha]) < 0.03, "the axis comes to rest within 0.03 rad of north");
  // Small oscillations without damping: period 2 pi sqrt(A / (C s Omega cos lambda)).
  const auto small = simulated(0.01, 0, 30, {when<System, u>("turns", crossing::rising)});
  const double period =
      2 * std::numbers::pi * std::sqrt(across / (about * spin * earth * std::cos(latitude)));
  page.expect(small.events.size() > 0, "the axis swings about north");
  if (!small.events.empty())
    page.expect_small("without damping, the period is 2π √(A / (C s Ω cos λ)) = " + page.rounded(period) +
                          " s",
                      std::abs(2 * small.events.front().t / period - 1), 0.01);
  return page.show<gyrocompass::picture>(run);
}
