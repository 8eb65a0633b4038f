// A car with rear-wheel drive drifts around a circle.
#include <kanexpr/simulate.hpp>
#include <kanexpr/tyres.hpp>
#include <parts/page.hpp>

namespace drifting_car {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr time_variable t;
constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"psi", radian> psi;
constexpr coordinate<"delta", radian> delta;
constexpr coordinate<"theta_f", radian> front_angle;
constexpr coordinate<"theta_r", radian> rear_angle;
constexpr speed<"u", meter / second> u; // forward
constexpr speed<"v", meter / second> v; // to the left
constexpr speed<"r"> r;
constexpr speed<"w_d"> steering;
constexpr speed<"w_f"> front_spin;
constexpr speed<"w_r"> rear_spin;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"a", meter> a; // from the center of mass to the axles
constexpr parameter<"b", meter> b;
constexpr parameter<"R", meter> R;
constexpr parameter<"mu", dimensionless> mu;
constexpr parameter<"C", newton> C;
constexpr parameter<"v0", meter / second> v0;
constexpr parameter<"V", meter / second> V;             // the speed before the drift
constexpr parameter<"V_r", meter / second> wheel_speed; // of the rear wheel, in the drift
constexpr parameter<"r_d", radian / second> yaw_rate;
constexpr parameter<"beta_d", radian> drift_angle;

struct N : inertial_frame<N> {}; // z points up
struct O : origin<O, N> {};
struct Body : rotated<Body, N, psi, N::z> {};
struct Fork : rotated<Fork, Body, delta, Body::z> {};
struct Front : rotated<Front, Fork, front_angle, Fork::y> {};
struct Rear : rotated<Rear, Body, rear_angle, Body::y> {};
struct G : offset<G, O, x * N::x + y * N::y + R * N::z> {};
struct FrontHub : offset<FrontHub, G, a * Body::x> {};
struct RearHub : offset<RearHub, G, -b * Body::x> {};

struct Car : rigid_body<Car, G, Body, m, inertia<Body, 600, 1600, 1600>> {};
struct FrontWheel : rigid_body<FrontWheel, FrontHub, Front, 30, inertia<Front, 1, 1.5, 1>> {};
struct RearWheel : rigid_body<RearWheel, RearHub, Rear, 30, inertia<Rear, 1, 1.5, 1>> {};

using FrontTyre = tyre<thin_wheel<FrontHub, Fork::y, R, Front>, flat_ground<O, N::z>, brush_tyre<mu, C>,
                       wheel_load<m * g * b / (a + b)>, standstill<v0>>;
using RearTyre = tyre<thin_wheel<RearHub, Body::y, R, Rear>, flat_ground<O, N::z>, brush_tyre<mu, C>,
                      wheel_load<m * g * a / (a + b)>, standstill<v0>>;

// The driver begins at four times T0: the throttle holds the drift angle, and the steering holds the yaw
// rate.
constexpr parameter<"T0", second> T0;
constexpr parameter<"k_beta", meter / second / radian> by_angle;
constexpr parameter<"k_t", newton * meter * second / radian> by_spin;
constexpr parameter<"k_r", second> by_yaw_rate;
constexpr parameter<"k_d", newton * meter / radian> arm; // of the steering
constexpr parameter<"c_d", newton * meter * second / radian> damping;
constexpr auto drifting = (1 + tanh(t / T0 - 4)) / 2;
constexpr auto slower = by_angle * (atan2(v, u) + drift_angle);
constexpr auto wanted_speed = V + (wheel_speed + slower - V) * drifting;
constexpr auto throttle = by_spin * (wanted_speed / R - rear_spin);
constexpr auto course = atan2(v + a * r, u) + by_yaw_rate * (yaw_rate * drifting - r);
constexpr auto steer = arm * (0.6 * tanh(course / 0.6) - delta) - damping * steering;

struct System
    : kane_system<inertial<N>, coordinates<x, y, psi, delta, front_angle, rear_angle>,
                  speeds<u, v, r, steering, front_spin, rear_spin>,
                  kinematics<dot(x) == u * cos(psi) - v * sin(psi), dot(y) == u * sin(psi) + v * cos(psi),
                             dot(psi) == r, dot(delta) == steering, dot(front_angle) == front_spin,
                             dot(rear_angle) == rear_spin>,
                  parameters<m, g, a, b, R, mu, C, v0, V, wheel_speed, yaw_rate, drift_angle, T0, by_angle,
                             by_spin, by_yaw_rate, arm, damping>,
                  bodies<Car, FrontWheel, RearWheel>,
                  loads<FrontTyre, RearTyre, torque_between<Rear, Body, throttle * Body::y>,
                        torque_between<Fork, Body, steer * Body::z>>> {};

struct Cabin : offset<Cabin, G, -0.2 * Body::x + 0.75 * Body::z> {};
struct Hood : offset<Hood, G, 0.25 * Body::z> {};
template <class Self, class Hub, class Frame, auto side>
struct beside : offset<Self, Hub, double(side) * 0.75 * Frame::y> {};
struct FL : beside<FL, FrontHub, Body, 1> {};
struct FR : beside<FR, FrontHub, Body, -1> {};
struct RL : beside<RL, RearHub, Body, 1> {};
struct RR : beside<RR, RearHub, Body, -1> {};

template <class P, class Frame>
using tire = show<cylinder<Frame, P, Frame::y, 0.2, R>, colour<"#33383d">>;

using picture = kanexpr::picture<System, up<N::z>, ground<0.0>, seen_from<-N::x - N::y + 1.6 * N::z>,
                                 trace<FrontHub, colour<"#d98a2b">>, trace<RearHub, colour<"#3d6b99">>,
                                 show<box<Body, Hood, 4.2, 1.7, 0.5>, colour<"#b5382f">>,
                                 show<box<Body, Cabin, 2, 1.5, 0.5>, colour<"#8f979e">>, tire<FL, Fork>,
                                 tire<FR, Fork>, tire<RL, Body>, tire<RR, Body>>;

} // namespace drifting_car

int main(int count, char** words) {
  using namespace drifting_car;
  gallery::page page(
      count, words,
      {.title = "Drifting car",
       .kind = "Vehicles",
       .see =
           "The rear wheel spins faster than the car moves, so its tyre slides, and the car turns with its "
           "nose inside of its path. The front wheel is steered outward, along the path. No steady drift "
           "is stable without a driver: here, the throttle holds the drift angle.",
       .source = "Velenis, Katzourakis, Frazzoli, Tsiotras & Happee, Steady-state drifting stabilization of "
                 "RWD vehicles, Control Engineering Practice 19 (2011); Pacejka, Tire and Vehicle Dynamics "
                 "(2012), section 3.2"});
  const auto run = simulate<System, integrator::bdf>(
      {{u, 10},
       {front_spin, 10 / 0.3},
       {rear_spin, 10 / 0.3},
       {x, 0},
       {y, 0},
       {psi, 0},
       {delta, 0},
       {front_angle, 0},
       {rear_angle, 0},
       {v, 0},
       {r, 0},
       {steering, 0}},
      {{m, 1300},
       {g, 9.81},
       {a, 1.2},
       {b, 1.4},
       {R, 0.3},
       {mu, 0.9},
       {C, 7e4},
       {v0, 0.5},
       {V, 10},
       {wheel_speed, 13},
       {yaw_rate, 0.8},
       {drift_angle, 0.6},
       {T0, 0.5},
       {by_angle, 20},
       {by_spin, 900},
       {by_yaw_rate, 2},
       {arm, 400},
       {damping, 40}},
      {0, 20}, {.relative_tolerance = 1e-8, .absolute_tolerance = 1e-8, .output_every = 0.02});
  const auto& end = run.state;
  const double sideslip = std::atan2(end[v], end[u]), velocity = std::hypot(end[u], end[v]);
  std::printf("drifts at %g degrees with %g m/s and %g rad/s, steered by %g degrees\n", sideslip * 57.29578,
              velocity, end[r], end[delta] * 57.29578);
  page.expect(sideslip < -0.4 && sideslip > -0.6, "the nose of the car points inside of its path");
  page.expect(end[delta] < -0.2, "the front wheel is steered outward");
  page.expect(end[rear_spin] * 0.3 > 1.2 * velocity, "the rear wheel spins");
  page.expect(std::abs(velocity * end[r] / (0.9 * 9.81) - 0.83) < 0.05,
              "the tyres use most of the friction to turn the car");
  return page.show<drifting_car::picture>(run, {.at = 12});
}
