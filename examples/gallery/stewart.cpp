// Six legs move a platform in all six directions.
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <parts/page.hpp>

namespace stewart {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"z", meter> z;
constexpr coordinate<"a", radian> a; // roll, pitch and yaw
constexpr coordinate<"b", radian> b;
constexpr coordinate<"c", radian> c;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"u4"> u4;
constexpr speed<"u5"> u5;
constexpr speed<"u6"> u6;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"J", kilogram * pow<2>(meter)> J;
constexpr parameter<"g", meter / pow<2>(second)> g;
template <int i>
constexpr input<"F", i, newton> F; // along leg i

struct N : inertial_frame<N> {}; // z points up
struct P : body_fixed<P, N, "xyz", a, b, c> {};
struct O : origin<O, N> {};
struct C : offset<C, O, x * N::x + y * N::y + z * N::z> {};

// Hexagons with sides of two lengths: the legs meet in pairs below and above, turned by 60 degrees.
struct place {
  double x, y;
};
constexpr double below = 1.2, above = 0.7; // radii, m
constexpr place feet[6]{{0.9848, 0.1736},   {-0.3420, 0.9397},  {-0.6428, 0.7660},
                        {-0.6428, -0.7660}, {-0.3420, -0.9397}, {0.9848, -0.1736}};
constexpr place tops[6]{{0.6428, 0.7660},   {0.3420, 0.9397},  {-0.9848, 0.1736},
                        {-0.9848, -0.1736}, {0.3420, -0.9397}, {0.6428, -0.7660}};

template <int i>
struct Foot : offset<Foot<i>, O, below * feet[i].x * N::x + below * feet[i].y * N::y> {};
template <int i>
struct Top : offset<Top<i>, C, above * tops[i].x * P::x + above * tops[i].y * P::y> {};
template <int i>
using leg = force_between<Top<i>, Foot<i>, F<i> * normalized(position_of<Top<i>, Foot<i>>)>;

struct Platform : rigid_body<Platform, C, P, m, inertia<P, I, I, J>> {};
struct System : kane_system<inertial<N>, coordinates<x, y, z, a, b, c>, speeds<u1, u2, u3, u4, u5, u6>,
                            kinematics<simple>, parameters<m, I, J, g>,
                            inputs<F<0>, F<1>, F<2>, F<3>, F<4>, F<5>>, bodies<Platform>,
                            loads<gravity<-g * N::z>, leg<0>, leg<1>, leg<2>, leg<3>, leg<4>, leg<5>>> {};

struct Middle : offset<Middle, C, 0.04 * P::z> {};
template <int i>
using strut = show<rod<Foot<i>, Top<i>, 0.03>, colour<"#3d6b99">>;
template <int i>
using balls = show<sphere<Foot<i>, 0.05>, colour<"#8f979e">>;
template <int i>
using ball_above = show<sphere<Top<i>, 0.045>, colour<"#8f979e">>;

using picture =
    kanexpr::picture<System, up<N::z>, ground<-0.05>, seen_from<N::x - 1.5 * N::y + 0.7 * N::z>,
                     trace<C, colour<"#d98a2b">>, strut<0>, strut<1>, strut<2>, strut<3>, strut<4>, strut<5>,
                     balls<0>, balls<1>, balls<2>, balls<3>, balls<4>, balls<5>, ball_above<0>, ball_above<1>,
                     ball_above<2>, ball_above<3>, ball_above<4>, ball_above<5>,
                     show<cylinder<P, Middle, P::z, 0.72, 0.06>, colour<"#b5382f">>>;

using vector6 = Eigen::Vector<double, 6>;

/// A motion with its rates: a circle, a rise, and rotations about all axes.
struct motion {
  vector6 q, u, a;
};
inline motion motion_at(double t) {
  const vector6 size(0.2, 0.2, 0.12, 0.2, 0.2, 0.25), rate(2, 2, 3, 2, 1.5, 1),
      phase(0, -std::numbers::pi / 2, 0, 0, 1, 0);
  const vector6 at = rate * t + phase;
  motion wanted{size.array() * at.array().sin(), size.array() * rate.array() * at.array().cos(),
                -size.array() * rate.array().square() * at.array().sin()};
  wanted.q(2) += 1.3;
  return wanted;
}

} // namespace stewart

int main(int count, char** words) {
  using namespace stewart;
  using eom = equations_of_motion<System>;
  gallery::page page(count, words,
                     {.title = "Stewart platform",
                      .kind = "Mechanisms",
                      .see = "Six legs change their lengths and carry the platform around a circle while it "
                             "rolls, pitches and yaws. The forces of "
                             "the legs are computed from the wanted accelerations, as in a flight simulator.",
                      .source = "Stewart, A platform with six degrees of freedom, Proceedings of the "
                                "Institution of Mechanical Engineers 180 "
                                "(1965), pages 371-386"});
  const parameter_values<System> p(100, 12, 24, 9.81);
  state<System> now;
  now.q() << 0, 0, 1.2, 0, 0, 0;
  trajectory<System> path(p);
  const double period = 0.002;
  double t = 0, late = 0;
  for (int k = 0; k < 10 / period; ++k) {
    const motion wanted = motion_at(t);
    const vector6 rates = wanted.a - 20 * (now.u() - wanted.u) - 100 * (now.q() - wanted.q);
    const input_values<System> legs = eom::required_inputs(now, p, input_values<System>::Zero(), rates);
    if (k % 10 == 0) path.add({t, now, legs});
    if (const status s = runge_kutta_4<System>{}(t, now, period, p, legs); !s) page.refuse(s.cause());
    if (t > 2) late = std::max(late, (now.q() - motion_at(t).q).cwiseAbs().maxCoeff());
  }
  page.expect_small("after two seconds the platform follows its motion", late, 5e-3);
  return page.show<stewart::picture>(path, {.at = 1, .loads = false});
}
