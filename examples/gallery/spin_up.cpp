// A slender arm is spun up, lags behind, and straightens again.
#include <kanexpr/animate/bent.hpp>
#include <kanexpr/beams.hpp>
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/prescribe.hpp>
#include <parts/page.hpp>

namespace spin_up {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr prescribed<"theta", radian> theta;          // angle of the hub
constexpr parameter<"L", meter> L;                    // length of the arm
constexpr parameter<"rho", kilogram / meter> rho;     // mass per length
constexpr parameter<"EI", newton * pow<2>(meter)> EI; // bending stiffness

struct N : inertial_frame<N> {};
struct Hub : rotated<Hub, N, theta, N::z> {};
struct O : origin<O, N> {};
struct Arm : beam<Arm, O, Hub::x, L, rho, bending<Hub::y, EI, clamped_free<3>>> {};
struct System : kane_system<inertial<N>, bodies<Arm>> {};

struct Tip : section<Tip, Arm, 1> {};
struct Straight : offset<Straight, O, L * Hub::x> {};

using picture =
    kanexpr::picture<System, up<N::y>, seen_from<N::z>, trace<Tip, colour<"#d98a2b">>,
                     show<rod<O, Straight, 0.015>, colour<"#8f979e">, opacity<0.5>, named<"straight arm">>,
                     show<bent<Arm, rectangle<0.12, 0.12>>, colour<"#3d6b99">>,
                     show<cylinder<Hub, O, Hub::z, 0.25, 0.3>, colour<"#33383d">, named<"hub">>,
                     plot<"deflection of the tip", dot(position_of<Tip, O>, Hub::y), "m">>;

constexpr double final_speed = 4, ramp = 15; // rad/s, s

/// The angle of the hub, whose speed rises smoothly during the ramp.
template <class Time>
Time angle_at(Time t) {
  using std::cos;
  if (t > ramp) return final_speed * (t - ramp / 2);
  const double w = 2 * std::numbers::pi / ramp;
  return final_speed / ramp * (t * t / 2 + (cos(w * t) - 1) / (w * w));
}

} // namespace spin_up

int main(int count, char** words) {
  using namespace spin_up;
  gallery::page page(
      count, words,
      {.title = "Spin-up of a flexible arm",
       .kind = "Flexible bodies",
       .see = "While the hub reaches four radians per second, the arm lags behind by half a meter; then the "
              "centrifugal force straightens it, although the hub finally turns faster than the first "
              "natural frequency of the arm. Linear theory without geometric stiffening predicts that the "
              "arm bends without bound.",
       .source = "Kane, Ryan & Banerjee, Dynamics of a cantilever beam attached to a moving base, Journal of "
                 "Guidance, Control, and Dynamics 10 (1987), pages 139-151; numbers of Wu & Haug (1988)"});
  const double length = 8, stiffness = 6.8952e10 * 8.2189e-9, mass = 2766.67 * 7.2986e-5; // m, N m², kg/m
  simulation_options<System> how{.output_every = 0.04};
  how.relative_tolerance = 1e-9;
  how.inputs = [](double t, const state<System>&, input_values<System>& r) {
    prescribe(r, theta, t, [](auto time) { return angle_at(time); });
  };
  const auto run =
      simulate<System>(state<System>::Zero(), {{L, length}, {rho, mass}, {EI, stiffness}}, {0, 20}, how);

  double lag = 0, after = 0;
  for (std::size_t i = 0; i < run.trajectory.size(); ++i) {
    const auto& x = run.trajectory[i].x; // each mode is 1 at the tip
    const double tip = x[q_of<Arm, 1>] + x[q_of<Arm, 2>] + x[q_of<Arm, 3>];
    lag = std::min(lag, tip);
    if (run.trajectory[i].t > ramp) after = std::max(after, std::abs(tip));
  }
  std::printf("lags %g, then %g\n", lag, after);
  page.expect_small("the greatest lag is 0.5346 m, as in an independent analysis", std::abs(lag + 0.53459),
                    1e-3);
  page.expect(after < 0.01, "the arm is straight again after the spin-up");
  page.expect(3.5160 * std::sqrt(stiffness / mass) / (length * length) < final_speed,
              "the hub turns faster than the first natural frequency of the arm");
  return page.show<spin_up::picture>(run, {.at = 6.8});
}
