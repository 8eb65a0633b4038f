// A motor swings a pendulum up by turning an arm, and balances it.
#include <kanexpr/control.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/numeric/as_eigen.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <parts/page.hpp>

namespace furuta {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"phi", radian> phi;     // of the arm
constexpr coordinate<"theta", radian> theta; // of the pendulum, zero where it stands
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // of the arm and the motor about the vertical
constexpr parameter<"m", kilogram> m;
constexpr parameter<"r", meter> r;                    // length of the arm
constexpr parameter<"d", meter> d;                    // from the joint to the pendulum's mass center
constexpr parameter<"I", kilogram * pow<2>(meter)> I; // of the pendulum about it
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr input<"T", newton * meter> T;

struct N : inertial_frame<N> {}; // z points up
struct A : rotated<A, N, phi, N::z> {};
struct B : rotated<B, A, theta, A::x> {};
struct O : origin<O, N> {};
struct Elbow : offset<Elbow, O, r * A::x> {};
struct G : offset<G, Elbow, d * B::z> {};
struct Arm : rigid_body<Arm, O, A, 0.1, inertia<A, 0, 0, J>> {};
struct Rod : rigid_body<Rod, G, B, m, inertia<B, I, I, 0>> {};

struct System : kane_system<inertial<N>, coordinates<phi, theta>, speeds<u1, u2>, kinematics<simple>,
                            parameters<J, m, r, d, I, g>, inputs<T>, bodies<Arm, Rod>,
                            loads<gravity<-g * N::z>, torque<A, T * N::z>>> {};

struct Tip : offset<Tip, Elbow, 2 * d * B::z> {};
struct Foot : offset<Foot, O, -0.25 * N::z> {};

using picture = kanexpr::picture<
    System, up<N::z>, ground<-0.25>, seen_from<N::x - 1.3 * N::y + 0.6 * N::z>, trace<Tip, colour<"#d98a2b">>,
    show<cylinder<N, Foot, N::z, 0.06, 0.04>, colour<"#8f979e">>,
    show<rod<Foot, O, 0.015>, colour<"#8f979e">>, show<rod<O, Elbow, 0.01>, colour<"#3d6b99">>,
    show<sphere<Elbow, 0.016>, colour<"#3d6b99">>, show<rod<Elbow, Tip, 0.008>, colour<"#b5382f">>,
    show<sphere<Tip, 0.014>, colour<"#b5382f">>>;

constexpr double period = 0.002; // s
constexpr auto numbers =
    constant_parameters<System>({{J, 2e-2}, {m, 0.1}, {r, 0.2}, {d, 0.15}, {I, 7.5e-4}, {g, 9.81}});
constexpr auto linear = discretize(linearization<System>::explicit_form.constant(
                                       constant_state<System>({{phi, 0}, {theta, 0}, {u1, 0}, {u2, 0}}),
                                       numbers, constant_inputs<System>({{T, 0}})),
                                   period);
constexpr auto regulator = dlqr(linear.A, linear.B, {1, 10, 0.1, 0.1}, {2});
static_assert(regulator);

/// Far from the top, the torque brings the energy of the pendulum to that of standing; near it, the regulator
/// acts.
inline double torque_at(const state<System>& x) {
  const double angle = std::remainder(x[theta], 2 * std::numbers::pi);
  if (std::abs(angle) < 0.5 && std::abs(x[u2]) < 6)
    return -(numeric::as_eigen(regulator.K) * Eigen::Vector4d(x[phi], angle, x[u1], x[u2])).value();
  const double weight = 0.1 * 9.81 * 0.15, about_joint = 7.5e-4 + 0.1 * 0.15 * 0.15;
  const double energy = about_joint * x[u2] * x[u2] / 2 + weight * (std::cos(angle) - 1);
  return std::clamp(-8 * energy * (x[u2] * std::cos(angle) > 0 ? 1 : -1), -0.2, 0.2) - 0.02 * x[u1] -
         0.1 * x[phi];
}

} // namespace furuta

int main(int count, char** words) {
  using namespace furuta;
  gallery::page page(
      count, words,
      {.title = "Furuta's pendulum",
       .kind = "Control",
       .see =
           "The motor turns the arm back and forth until the pendulum has the energy of standing, and then a "
           "regulator catches it. The compiler linearized the system at the top and computed the gains.",
       .source =
           "Furuta, Yamakita & Kobayashi, Swing-up control of inverted pendulum using pseudo-state feedback, "
           "Journal of Systems and Control Engineering 206 (1992); Åström & Furuta, Automatica 36 (2000), "
           "pages 287-295"});
  const parameter_values<System> p(2e-2, 0.1, 0.2, 0.15, 7.5e-4, 9.81);
  state<System> x{{phi, 0}, {theta, std::numbers::pi - 0.05}, {u1, 0}, {u2, 0}};
  trajectory<System> path(p);
  double t = 0;
  for (int k = 0; k < 8 / period; ++k) {
    const input_values<System> acting(torque_at(x));
    if (k % 10 == 0) path.add({t, x, acting});
    if (const status s = runge_kutta_4<System>{}(t, x, period, p, acting); !s) page.refuse(s.cause());
  }
  std::printf("ends at %g %g\n", x[theta], x[phi]);
  page.expect(std::abs(std::remainder(x[theta], 2 * std::numbers::pi)) < 0.01 && std::abs(x[u2]) < 0.05,
              "the pendulum stands at the end");
  return page.show<furuta::picture>(path, {.at = 0.5});
}
