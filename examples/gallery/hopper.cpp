// A leg hops to and fro under a controller whose memory is a state of the system.
#include <kanexpr/blocks.hpp>
#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace hopper {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr parameter<"m", kilogram> m; // of the body; the thigh and the foot are 10 and 50 times lighter
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // of the body
constexpr parameter<"l", meter> l;                    // length of the leg
constexpr parameter<"k", newton / meter> k;           // stiffness of the leg
constexpr parameter<"c", newton * second / meter> c;  // damping of the leg
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"h", meter> h;    // desired height of the hip at the top of a hop
constexpr parameter<"Ts", second> Ts; // duration of a stance
constexpr parameter<"kv", second> kv; // by how much the foot is placed ahead if the body is too fast
constexpr parameter<"kp", newton * meter / radian> kp;
constexpr parameter<"kd", newton * meter * second / radian> kd;
constexpr parameter<"ka", newton / joule> ka; // gains of the thrust
constexpr parameter<"ki", newton / joule / second> ki;
constexpr parameter<"d", meter> d;          // the stance begins when the leg is shortened by this length
constexpr parameter<"w", meter / second> w; // and the thrust when it lengthens at this speed
constexpr input<"vd", meter / second> desired;
constexpr state_variable<"A", newton> A; // the thrust that the leg has learned to need

struct N : inertial_ground<N> {}; // x to the right, z up
struct Body : planar<Body, N, axis<N::x, N::z>, body<m, 0.0 * own::x, inertia<own, J, J, J>>> {};
struct Thigh : pin<Thigh, Body, axis<-1.0 * N::y>,
                   body<0.1 * m, -0.2 * l * own::z, inertia<own, J / 100, J / 100, J / 100>>> {};
struct Foot : prismatic<Foot, Thigh, axis<-1.0 * Thigh::z>, stops<0.2, 0.53, 2e4, 0.5>,
                        body<0.02 * m, 0.0 * own::x>> {};

struct Speed : lag<Speed, u_of<Body, 1>, 0.1> {};

constexpr auto shortened = l - q_of<Foot>;
constexpr auto stance = shortened * shortened / (shortened * shortened + d * d); // from 0 to 1
constexpr auto missing_energy =
    1.12 * m * (g * (h - q_of<Body, 2>)-u_of<Body, 2> * u_of<Body, 2> / 2) - k * shortened * shortened / 2;
constexpr auto thrust = stance * (ka * missing_energy + A) * (1 + tanh(u_of<Foot> / w)) / 2;
constexpr auto ahead = (Speed::output * Ts / 2 + kv * (Speed::output - desired)) / l;
constexpr auto of_leg = q_of<Body, 3> + q_of<Thigh>;
constexpr auto swing = kp * (ahead - of_leg) - kd * (u_of<Body, 3> + u_of<Thigh>);
constexpr auto upright = 3.0 * kp * q_of<Body, 3> + 3.0 * kd * u_of<Body, 3>;
constexpr auto torque_of_hip = (1 - stance) * swing + stance * upright;

using Ground = contact<point_on_plane<Foot, N, N::z>, elastic<4e4>, smoothed_over<1e-3>, dissipation<0.6>,
                       coulomb_friction<0.9, 0.03>>;

struct System : kane_system<inertial<N>, joints<Body, Thigh, Foot>, blocks<Speed>, states<A>,
                            dynamics<dot(A) == ki * stance * missing_energy>,
                            parameters<m, J, l, k, c, g, h, Ts, kv, kp, kd, ka, ki, d, w>, inputs<desired>,
                            loads<gravity<-g * N::z>, Ground, linear_spring<Foot, k, l>,
                                  linear_damper<Foot, c>, motor<Foot, thrust>, motor<Thigh, torque_of_hip>>> {
};

struct Thigh_middle : offset<Thigh_middle, Thigh, -0.2 * l * Thigh::z> {};
constexpr auto momentum = m * (dot(velocity_of<Body>, N::x) + 0.1 * dot(velocity_of<Thigh_middle>, N::x) +
                               0.02 * dot(velocity_of<Foot>, N::x));

constexpr auto foot_height = dot(position_of<Foot, N>, N::z);

struct Knee : offset<Knee, Thigh, -0.22 * Thigh::z> {};
struct Trunk : offset<Trunk, Body, 0.03 * Body::z> {};

using picture =
    kanexpr::picture<System, up<N::z>, ground<>, seen_from<0.3 * N::x - N::y + 0.25 * N::z>,
                     trace<Body, colour<"#d98a2b">>,
                     show<box<Body, Trunk, 0.4, 0.16, 0.12>, named<"body">, colour<"#3d6b99">>,
                     show<cylinder<Body, Body, Body::y, 0.05, 0.2>, named<"hip">, colour<"#565e66">>,
                     show<rod<Body, Knee, 0.025>, named<"thigh">, colour<"#b5382f">>,
                     show<coil<Knee, Foot, 0.035, 8>, named<"leg">, colour<"#7b8794">>,
                     show<rod<Knee, Foot, 0.01>, named<"piston">, colour<"#9aa3ab">>,
                     show<sphere<Foot, 0.03>, named<"foot">, colour<"#2b3036">>, plot<"stance", stance>,
                     plot<"thrust", thrust>, plot_energies<>, show_forces<"N">>;

} // namespace hopper

int main(int count, char** words) {
  using namespace hopper;
  gallery::page page(
      count, words,
      {.title = "Hopping leg",
       .kind = "Control",
       .see =
           "In flight, the hip places the foot for the desired speed; in stance, it keeps the body upright, "
           "and the leg pushes. The desired speed changes twice. Two states remember what the controller "
           "needs to know: a filter the speed, and an integral the thrust that replaces the energy of each "
           "impact.",
       .source = "Raibert, Legged Robots That Balance (1986), chapter 2"});
  simulation_options<System> how{
      .relative_tolerance = 1e-8, .absolute_tolerance = 1e-10, .output_every = 0.01};
  how.inputs = [](double t, const state<System>&, input_values<System>& r) {
    const auto step = [t](double at) { return (1 + std::tanh((t - at) / 0.3)) / 2; };
    r[desired] = step(1) - 2 * step(4.5) + step(8);
  };
  const double leg = 0.5, height = 0.62;
  state<System> x = state<System>::Zero();
  x[q_of<Body, 2>] = height, x[q_of<Foot>] = leg;
  const auto run = simulate<System, integrator::bdf>(x,
                                                     {{m, 10},
                                                      {J, 1},
                                                      {l, leg},
                                                      {k, 3000},
                                                      {c, 8},
                                                      {g, 9.81},
                                                      {h, height},
                                                      {Ts, 0.225},
                                                      {kv, 0.05},
                                                      {kp, 60},
                                                      {kd, 6},
                                                      {ka, 14},
                                                      {ki, 8},
                                                      {d, 0.02},
                                                      {w, 0.2}},
                                                     {0, 10}, how);
  const auto& path = run.trajectory;
  const auto momenta = path.along<momentum>(), heights = path.along<foot_height>();
  double farthest = 0, top = 0, most_drift = 0;
  std::size_t last_ground = 0;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double z = path[i].x[q_of<Body, 2>];
    farthest = std::max(farthest, path[i].x[q_of<Body, 1>]);
    if (z > path[i - 1].x[q_of<Body, 2>] && z > path[i + 1].x[q_of<Body, 2>]) top = z;
    if (heights[i] < 2e-3) last_ground = i;
    if (i > last_ground + 1)
      most_drift = std::max(most_drift, std::abs(momenta[i] - momenta[last_ground + 2]));
  }
  std::printf("as far as %g m, back at %g m; the last top is at %g m\n", farthest, run.state[q_of<Body, 1>],
              top);
  page.expect_small("the horizontal momentum is constant in every flight", most_drift / 10, 1e-5);
  page.expect_small("the last hop reaches the desired height", std::abs(top / height - 1), 0.03);
  page.expect(farthest > 2 && std::abs(run.state[q_of<Body, 1>]) < 0.4, "the leg hops 2 m ahead and back");
  return page.show<hopper::picture>(run, {.at = 0.5});
}
