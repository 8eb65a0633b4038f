// A crane carries its load across a yard and stops it without swinging.
#include <kanexpr/control.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/numeric/as_eigen.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <parts/page.hpp>

namespace crane {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"theta", radian> theta;
constexpr speed<"v"> v;
constexpr speed<"omega"> omega;
constexpr parameter<"m1", kilogram> m1; // trolley
constexpr parameter<"m2", kilogram> m2; // load
constexpr parameter<"l", meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr input<"F", newton> F;

struct N : inertial_frame<N> {};          // y points up
struct A : rotated<A, N, theta, N::z> {}; // the rope
struct O : origin<O, N> {};
struct C : offset<C, O, x * N::x> {};
struct P : offset<P, C, -l * A::y> {};
struct Trolley : particle<Trolley, C, m1> {};
struct Load : particle<Load, P, m2> {};
struct System : kane_system<inertial<N>, coordinates<x, theta>, speeds<v, omega>, kinematics<simple>,
                            parameters<m1, m2, l, g>, bodies<Trolley, Load>,
                            loads<gravity<-g * N::y>, force<C, F * N::x>>> {};

struct Start : offset<Start, O, -1.5 * N::x + 0.45 * N::y> {};
struct End : offset<End, O, 12 * N::x + 0.45 * N::y> {};
struct Block : offset<Block, P, -0.5 * A::y> {};

using picture = kanexpr::picture<System, up<N::y>, ground<-8.2>, seen_from<N::z + 0.25 * N::x + 0.12 * N::y>,
                                 trace<P, colour<"#d98a2b">>,
                                 show<rod<Start, End, 0.12>, colour<"#8f979e">, named<"rail">>,
                                 show<box<N, C, 1.2, 0.6, 0.9>, colour<"#3d6b99">, named<"trolley">>,
                                 show<rod<C, P, 0.05>, colour<"#33383d">, named<"rope">>,
                                 show<box<A, Block, 1.4, 1, 1.2>, colour<"#b5382f">, named<"load">>>;

constexpr double period = 0.02, distance = 10; // s, m
constexpr auto numbers = constant_parameters<System>({{m1, 2000}, {m2, 5000}, {l, 6}, {g, 9.81}});
constexpr auto linear = discretize(linearization<System>::explicit_form.constant(
                                       constant_state<System>({{x, 0}, {theta, 0}, {v, 0}, {omega, 0}}),
                                       numbers, constant_inputs<System>({{F, 0}})),
                                   period);
constexpr auto regulator = dlqr(linear.A, linear.B, {1, 200, 0, 0}, {1e-6});
static_assert(regulator);

} // namespace crane

int main(int count, char** words) {
  using namespace crane;
  gallery::page page(count, words,
                     {.title = "Crane",
                      .kind = "Pendulums",
                      .see = "The trolley moves the load by ten meters and stops with the load hanging "
                             "still. It leans into the swing "
                             "on the way, because the gains that the compiler computed weigh the swing as "
                             "well as the distance.",
                      .source = "Abdel-Rahman, Nayfeh & Masoud, Dynamics and control of cranes: a review, "
                                "Journal of Vibration and "
                                "Control 9 (2003), pages 863-908"});
  const parameter_values<System> p(2000, 5000, 6, 9.81);
  state<System> now{{x, 0}, {theta, 0}, {v, 0}, {omega, 0}};
  const state<System> goal{{x, distance}, {theta, 0}, {v, 0}, {omega, 0}};
  trajectory<System> path(p);
  double t = 0, widest = 0;
  for (int k = 0; k < 25 / period; ++k) {
    const input_values<System> acting(-(numeric::as_eigen(regulator.K) * (now - goal)).value());
    if (k % 2 == 0) path.add({t, now, acting});
    if (const status s = runge_kutta_4<System>{}(t, now, period, p, acting); !s) page.refuse(s.cause());
    widest = std::max(widest, std::abs(now[theta]));
  }
  std::printf("widest %g, ends at %g %g\n", widest, now[x], now[theta]);
  page.expect(widest > 0.05, "the load swings on the way");
  page.expect(std::abs(now[x] - distance) < 0.05 && std::abs(now[theta]) < 0.005,
              "the load hangs still at ten meters");
  return page.show<crane::picture>(path, {.at = 1});
}
