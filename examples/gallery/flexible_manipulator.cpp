// An arm of two flexible links moves its load, and stops without swinging.
#include <kanexpr/animate/bent.hpp>
#include <kanexpr/beams.hpp>
#include <kanexpr/control.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/numeric/as_eigen.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <parts/page.hpp>

namespace flexible_manipulator {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr parameter<"L", meter> L;                    // length of each link
constexpr parameter<"rho", kilogram / meter> rho;     // mass per length
constexpr parameter<"EI", newton * pow<2>(meter)> EI; // bending stiffness
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // of each motor
constexpr parameter<"m", kilogram> m;                 // of the motor at the elbow
constexpr parameter<"M", kilogram> M;                 // of the load
constexpr input<"T1", newton * meter> T1;
constexpr input<"T2", newton * meter> T2;

struct N : inertial_frame<N> {}; // the arm moves in a horizontal plane
struct O : origin<O, N> {};
constexpr coordinate<"q1", radian> q1;
constexpr coordinate<"q2", radian> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;

struct A : rotated<A, N, q1, N::z> {};
struct Upper : beam<Upper, O, A::x, L, rho, bending<A::y, EI, clamped_free<1>>, modal_damping<0.01>> {};
struct Elbow : section<Elbow, Upper, 1> {};
struct B : rotated<B, Elbow, q2, N::z> {};
struct Lower : beam<Lower, Elbow, B::x, L, rho, bending<B::y, EI, clamped_free<1>>, modal_damping<0.01>> {};
struct Hand : section<Hand, Lower, 1> {};

struct Shoulder_motor : rigid_body<Shoulder_motor, O, A, 1, inertia<A, J, J, J>> {};
struct Elbow_motor : rigid_body<Elbow_motor, Elbow, B, m, inertia<B, J, J, J>> {};
struct Load : particle<Load, Hand, M> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, kinematics<simple>,
                            inputs<T1, T2>, bodies<Shoulder_motor, Elbow_motor, Load, Upper, Lower>,
                            loads<torque<A, T1 * N::z>, torque_between<B, Elbow, T2 * N::z>>> {};

using picture =
    kanexpr::picture<System, up<N::z>, ground<-0.15>, seen_from<-0.4 * N::x - N::y + 1.2 * N::z>,
                     trace<Hand, colour<"#d98a2b">>,
                     show<bent<Upper, rectangle<0.05, 0.012>>, colour<"#3d6b99">>,
                     show<bent<Lower, rectangle<0.05, 0.012>>, colour<"#b5382f">>,
                     show<cylinder<A, O, A::z, 0.06, 0.12>, colour<"#33383d">, named<"shoulder">>,
                     show<cylinder<B, Elbow, B::z, 0.04, 0.08>, colour<"#33383d">, named<"elbow">>,
                     show<sphere<Hand, 0.05>, colour<"#d98a2b">, named<"load">>>;

constexpr double period = 0.001, moving = 2;                                                // s
constexpr double from_shoulder = -0.6, from_elbow = 1.8, to_shoulder = 1.2, to_elbow = 0.5; // rad
constexpr auto numbers =
    constant_parameters<System>({{L, 1}, {rho, 0.5}, {EI, 40}, {J, 0.01}, {m, 0.5}, {M, 0.25}});
constexpr auto goal = constant_state<System>({{q1, to_shoulder},
                                              {q2, to_elbow},
                                              {q_of<Upper, 1>, 0},
                                              {q_of<Lower, 1>, 0},
                                              {u1, 0},
                                              {u2, 0},
                                              {u_of<Upper, 1>, 0},
                                              {u_of<Lower, 1>, 0}});
constexpr auto linear = discretize(
    linearization<System>::explicit_form.constant(goal, numbers, constant_inputs<System>({{T1, 0}, {T2, 0}})),
    period);
constexpr auto regulator = dlqr(linear.A, linear.B, {100, 100, 400, 400, 1, 1, 4, 4}, {0.2, 0.2});
static_assert(regulator);

using eom = equations_of_motion<System>;

/// The straight arm on its way: a polynomial from rest to rest with the least jerk.
struct straight_arm {
  state<System> at = state<System>::Zero();
  Eigen::Vector4d acceleration = Eigen::Vector4d::Zero();

  explicit straight_arm(double t) {
    const double s = std::clamp(t / moving, 0.0, 1.0), left = 1 - s;
    const double part = s * s * s * (10 - s * (15 - 6 * s)), rate = 30 / moving * s * s * left * left;
    const double second = 60 / (moving * moving) * s * left * (left - s);
    const double shoulder = to_shoulder - from_shoulder, elbow = to_elbow - from_elbow;
    at[q1] = from_shoulder + part * shoulder;
    at[q2] = from_elbow + part * elbow;
    at[u1] = rate * shoulder;
    at[u2] = rate * elbow;
    acceleration << second * shoulder, second * elbow, 0, 0;
  }
};

/// The torques that accelerate the straight arm, and those of the regulator.
inline input_values<System> torques(double t, const state<System>& x, const parameter_values<System>& p) {
  const straight_arm wanted(t);
  const auto rigid = eom::mass_matrix(t, wanted.at, p, input_values<System>::Zero());
  const Eigen::Vector2d forward = (rigid * wanted.acceleration).template head<2>();
  return input_values<System>(forward - numeric::as_eigen(regulator.K) * (x - wanted.at));
}

} // namespace flexible_manipulator

int main(int count, char** words) {
  using namespace flexible_manipulator;
  gallery::page page(
      count, words,
      {.title = "Flexible manipulator",
       .kind = "Flexible bodies",
       .see = "Two links as slender as rulers carry a load on a smooth path. The links bend by "
              "centimeters while the motors accelerate them, and the regulator, whose gains the "
              "compiler computed, takes the vibration out at the end.",
       .source = "De Luca & Siciliano, Closed-form dynamic model of planar multilink lightweight "
                 "robots, IEEE Transactions on Systems, Man, and Cybernetics 21 (1991), pages "
                 "826-839"});
  const parameter_values<System> p(numbers.data());
  state<System> x = straight_arm(0).at;
  trajectory<System> path(p);
  double t = 0, widest = 0, swings = 0;
  for (int k = 0; k < 3.5 / period; ++k) {
    const input_values<System> acting = torques(t, x, p);
    if (k % 20 == 0) path.add({t, x, acting});
    if (const status s = runge_kutta_4<System>{}(t, x, period, p, acting); !s) page.refuse(s.cause());
    const double bent = std::max(std::abs(x[q_of<Upper, 1>]), std::abs(x[q_of<Lower, 1>]));
    widest = std::max(widest, bent);
    if (t > moving + 0.5) swings = std::max(swings, bent);
  }
  std::printf("bends by %g, swings by %g at the end\n", widest, swings);
  page.expect(widest > 0.01, "the links bend by more than a centimeter on the way");
  page.expect(swings < 1e-3, "half a second later, the links swing by less than a millimeter");
  page.expect(std::abs(x[q1] - to_shoulder) < 1e-3 && std::abs(x[q2] - to_elbow) < 1e-3,
              "the arm ends in the wanted posture");
  return page.show<flexible_manipulator::picture>(path, {.at = 0.5});
}
