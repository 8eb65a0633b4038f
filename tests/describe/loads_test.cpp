// builds: clang++
// Loads in different words, and loads that depend on motion, compared with the same loads written out. The
// systems are derived at run time, because only the reading is compared.
#include <kanexpr/symbolic.hpp>

#include "models/four_bar.hpp"
#include "models/pendulum_nonminimal.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace kanexpr;

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr coordinate<"q3"> q3;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr parameter<"k"> k;
constexpr parameter<"c"> c;
constexpr input<"F"> F;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::x> {};
struct O : origin<O, N> {};
struct Wall : offset<Wall, O, 0.3 * N::x - 0.5 * N::z> {};
struct P : offset<P, O, l * A::y + 0.1 * A::z> {};
struct Q : offset<Q, P, q3 * B::y + 0.2 * B::z> {};
struct Elbow : rigid_body<Elbow, P, A, m, inertia<A, 0.2, 0.3, 0.4>> {};
struct Slider : rigid_body<Slider, Q, B, 2 * m, inertia<B, 0.1, 0.2, 0.3>> {};

/// An elbow with a slider on it, under some loads.
template <class... Loads>
struct arm : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                         kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3 - u1>, parameters<m, l, k, c>,
                         inputs<F>, used_elsewhere<k, c, F>, bodies<Elbow, Slider>,
                         loads<gravity<-9.81 * N::z>, Loads...>> {};

/// Results at some states, one below the other.
template <class System, class... Quantities>
Eigen::MatrixXd numbers(Eigen::Index parameters, double least, Quantities... wanted) {
  auto derived = derive<System>();
  EXPECT_EQ(derived.mistake(), "");
  std::mt19937_64 source(7);
  std::uniform_real_distribution<double> values(least, 1.2);
  const auto some = [&](Eigen::Index size) {
    Eigen::VectorXd v(size);
    for (double& value : v) value = values(source);
    return v;
  };
  Eigen::MatrixXd all(0, 6);
  for (Eigen::Index state = 0; state < all.cols(); ++state) {
    const Eigen::VectorXd x = some(derived.rhs().rows), p = some(parameters), r = some(1);
    Eigen::Index row = 0;
    (
        [&] {
          const Eigen::VectorXd found = derived.function(derived.get(wanted))(x, p, r).reshaped();
          if (all.rows() < row + found.size()) all.conservativeResize(row + found.size(), Eigen::NoChange);
          all.col(state).segment(row, found.size()) = found;
          row += found.size();
        }(),
        ...);
  }
  return all;
}

void expect_equal(const Eigen::MatrixXd& first, const Eigen::MatrixXd& second) {
  EXPECT_LT((first - second).cwiseAbs().maxCoeff(), 1e-12 * first.cwiseAbs().maxCoeff());
}

template <class First, class Second>
void expect_same_motion() {
  expect_equal(numbers<First>(4, 0.4, mechanics::quantity::rhs),
               numbers<Second>(4, 0.4, mechanics::quantity::rhs));
}

struct Low : offset<Low, O, q1 * N::z> {};
struct Ball : particle<Ball, Low, m> {};
struct Falling : kane_system<inertial<N>, coordinates<q1>, speeds<u1>, kinematics<dot(q1) == u1>,
                             parameters<m, c>, bodies<Ball>, loads<gravity<-9.81 * N::z>, drag<Low, c>>> {};

constexpr auto line = position_of<Q, Wall>;
constexpr auto rate = velocity_of<Q> - velocity_of<Wall>;

} // namespace

TEST(loads, springs_and_dampers) {
  constexpr auto pull = -k * (magnitude(line) - 0.4) * normalized(line);
  expect_same_motion<arm<spring<Q, Wall, k, 0.4>>, arm<force<Q, pull>, force<Wall, -pull>>>();
  expect_same_motion<arm<spring<Wall, Q, k>>, arm<force<Q, -k * line>>>();
  expect_same_motion<arm<spring<Wall, Q, k, l>>,
                     arm<potential_energy<k * pow(magnitude(line) - l, 2) / 2>>>();
  constexpr auto drag = -c * dot(rate, line) / dot(line, line) * line;
  expect_same_motion<arm<damper<Wall, Q, c>>, arm<force_between<Q, Wall, drag>>>();
  expect_same_motion<arm<damper<Q, Wall, c>, spring<Wall, Q, k>>, arm<spring<Q, Wall, k>, force<Q, drag>>>();
  expect_same_motion<arm<damper<P, Q, c * magnitude(rate)>>,
                     arm<damper<Q, P, c * sqrt(dot(velocity_of<Q>, velocity_of<Q>))>>>();
}

TEST(loads, drag_is_against_the_velocity_and_with_its_square) {
  expect_same_motion<arm<drag<Q, c>>, arm<force<Q, -c * magnitude(rate) * rate>>>();
  expect_same_motion<arm<drag<P, c * (1 + q3)>, drag<Q, k>>,
                     arm<force<P, -c * (1 + q3) * l * sqrt(u1 * u1) * velocity_of<P>>,
                         force<Q, -k * sqrt(dot(rate, rate)) * rate>>>();
}

// A body that falls from rest reaches v = √(m g / c) tanh t √(c g / m).
TEST(loads, drag_of_a_falling_body) {
  using eom = equations_of_motion<Falling>;
  const eom::parameters p{{m, 2}, {c, 0.3}};
  eom::state x{{q1, 0}, {u1, 0}};
  const double step = 1e-3;
  for (int i = 0; i < 1500; ++i) { // Runge-Kutta
    const auto k1 = eom::rhs(x, p), k2 = eom::rhs(eom::state(x + step / 2 * k1), p),
               k3 = eom::rhs(eom::state(x + step / 2 * k2), p), k4 = eom::rhs(eom::state(x + step * k3), p);
    x += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  EXPECT_NEAR(x[u1], -std::sqrt(2 * 9.81 / 0.3) * std::tanh(1.5 * std::sqrt(0.3 * 9.81 / 2)), 1e-11);
}

TEST(loads, turning) {
  expect_same_motion<arm<torsional_spring<q2, k>>,
                     arm<torque<B, -k * q2 * A::x>, torque<A, k * q2 * A::x>>>();
  expect_same_motion<arm<torsional_spring<2 * q1, k, 0.3>>, arm<torque<A, -2 * k * (2 * q1 - 0.3) * N::z>>>();
  expect_same_motion<arm<torsional_damper<B, A, c>>, arm<torque_between<B, A, -c * u2 * A::x>>>();
  expect_same_motion<arm<torsional_damper<B, N, c>>, arm<torque<B, -c*(u1 * N::z + u2 * A::x)>>>();
  expect_same_motion<arm<torque_between<A, B, F * N::y + k * B::x>>,
                     arm<torque<A, F * N::y + k * B::x>, torque<B, -F * N::y - k * B::x>>>();
  expect_same_motion<arm<force_between<Q, P, F * N::y>>, arm<force<Q, F * N::y>, force<P, -F * N::y>>>();
}

namespace {

// v_P = −l u1 x; v_Q = v_P + d/dt (q3 B.y + 0.2 B.z), with ω_B = u1 z + u2 x
constexpr auto turning = u1 * N::z + u2 * A::x;
constexpr auto of_p = -l * u1 * A::x;
constexpr auto of_q = of_p + (u3 - u1) * B::y + cross(turning, q3* B::y + 0.2 * B::z);
struct NamedP : offset<NamedP, O, l * A::y + 0.1 * A::z>, velocity<N, of_p> {};

} // namespace

TEST(loads, of_motion) {
  expect_same_motion<arm<force<P, -c * velocity_of<P>>>, arm<force<P, -c * of_p>>>();
  expect_same_motion<arm<force<P, -c * velocity_of<P>>>, arm<force<P, -c * velocity_of<NamedP>>>>();
  expect_same_motion<arm<force<Q, -c * magnitude(velocity_of<Q>) * velocity_of<Q> + F * B::x>>,
                     arm<force<Q, -c * magnitude(of_q) * of_q + F * B::x>>>();
  expect_same_motion<arm<force<Q, -c * derivative_in<A>(position_of<Q, P>)>>,
                     arm<force<Q, -c*((u3 - u1) * B::y + cross(u2 * A::x, q3 * B::y + 0.2 * B::z))>>>();
  expect_same_motion<arm<torque<B, -c * angular_velocity_of<B> + derivative(q1 * F) * B::x>>,
                     arm<torque<B, -c * turning + u1 * F * B::x>>>();
  expect_same_motion<arm<force<Q, dot(in_axes_of<A>(line), A::x) * A::x + partial(k * q1 * q1, q1) * A::y>>,
                     arm<force<Q, dot(line, A::x) * A::x + 2 * k * q1 * A::y>>>();
}

// Unlisted parameters and inputs are in the order in which the model mentions them, including those in loads
// that depend on motion.
TEST(loads, of_motion_keep_the_order_of_mention) {
  struct Late : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                            kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3>, bodies<Elbow>,
                            loads<force<Q, -c * velocity_of<Q> + F * N::x>, torque<A, k * N::z>>> {};
  auto derived = derive<Late>();
  ASSERT_EQ(derived.mistake(), "");
  std::string names;
  for (const auto& p : derived.mechanism().parameters) names += symbolic::print(p) + " ";
  EXPECT_EQ(names, "m l c k ");
  EXPECT_EQ(derived.equations().loads_used().forces.size(), 1);
  EXPECT_EQ(derived.mechanism().inputs.size(), 1);
}

namespace {

constexpr speed<"lift"> lift;
constexpr prescribed<"theta"> theta;
struct Turned : rotated<Turned, N, theta + q1, N::z> {};
struct Carrier : offset<Carrier, O, q3 * Turned::x>,
                 velocity<Turned, dot(q3) * Turned::x + lift * Turned::z> {};
struct Bead : particle<Bead, Carrier, m> {};

template <class Load>
struct carried
    : kane_system<inertial<N>, coordinates<q1, q3>, speeds<u1, u3>, auxiliary<lift>, parameters<m, c>,
                  used_elsewhere<c>, kinematics<dot(q1) == u1, dot(q3) == u3>, bodies<Bead>, loads<Load>> {};

template <class Load>
Eigen::VectorXd carried_motion() {
  auto derived = derive<carried<Load>>();
  EXPECT_EQ(derived.mistake(), "");
  EXPECT_EQ(derived.auxiliary_forces()(0, 0), derived.noncontributing_forces()(0, 0));
  const Eigen::Vector4d x(0.4, 0.7, -1.1, 0.9);
  const Eigen::Vector2d p(1.3, 0.6);
  const Eigen::Vector3d r(0.2, -0.8, 0.5);
  Eigen::VectorXd all(3);
  all << derived.function(derived.udot())(x, p, r),
      derived.function(derived.noncontributing_forces())(x, p, r);
  return all;
}

} // namespace

namespace {

constexpr auto from_wall = position_of<P, Wall>;
constexpr auto from_elbow = position_of<Q, P>;
constexpr auto cable = magnitude(from_elbow) + magnitude(from_wall);
using over_elbow = through<Q, P, Wall>;

} // namespace

TEST(loads, along_pathways) {
  expect_same_motion<arm<linear_spring<straight<Q, Wall>, k, 0.4>, linear_damper<straight<Wall, Q>, c>>,
                     arm<spring<Q, Wall, k, 0.4>, damper<Q, Wall, c>>>();
  expect_same_motion<arm<force_along<straight<Q, Wall>, F>>,
                     arm<force_between<Q, Wall, -F * normalized(line)>>>();
  expect_same_motion<arm<force_along<straight<Q, Wall>, c * derivative(magnitude(line))>>,
                     arm<damper<Q, Wall, c>>>();
  expect_same_motion<arm<force_along<over_elbow, F>>,
                     arm<force_between<Q, P, -F * normalized(from_elbow)>,
                         force_between<P, Wall, -F * normalized(from_wall)>>>();
  expect_same_motion<arm<linear_spring<over_elbow, k, l>>,
                     arm<potential_energy<k * pow(cable - l, 2) / 2>>>();
  expect_same_motion<arm<linear_damper<over_elbow, c>>,
                     arm<force_along<over_elbow, c * derivative(cable)>>>();
  expect_same_motion<arm<cubic_spring<over_elbow, k, c>>,
                     arm<potential_energy<k * pow(cable, 2) / 2>, potential_energy<c * pow(cable, 4) / 4>>>();
  expect_same_motion<arm<linear_spring<given_length<q1 - 0.3 * q3>, k, 0.2>>,
                     arm<potential_energy<k * pow(q1 - 0.3 * q3 - 0.2, 2) / 2>>>();
  expect_same_motion<arm<linear_damper<given_length<2 * q2>, c>>,
                     arm<torque_between<B, A, -4 * c * u2 * A::x>>>();
}

TEST(loads, at_stops) {
  constexpr auto beyond = q2 - 0.6;
  constexpr auto one_sided = max(beyond - 0.001, 0);
  constexpr auto t = clamp(beyond / 0.001, 0, 1);
  constexpr auto elastic = k * (0.001 * t * t * t * (1 - t / 2) + one_sided);
  using stopped = arm<stop<given_length<q2>, 0.0, 0.6, k, 0.2, 0.001>>;
  expect_same_motion<stopped, arm<torque_between<B, A, -elastic * (1 + 0.2 * u2) * A::x>>>();
  expect_same_motion<stopped, arm<stop<given_length<q2>, 0.0, 0.6, k, rational<1, 5>, 0.001>>>();
  expect_same_motion<arm<stop<given_length<q2>, 0.1, 0.6, k, 0.2>>,
                     arm<stop<given_length<q2>, 0.1, 0.6, k, 0.2, 0.0005>>>();
}

TEST(loads, around_surfaces) {
  constexpr auto p = position_of<Q, P>, q = position_of<Wall, P>;
  constexpr auto first = sqrt(dot(p, p) - 0.01);
  constexpr auto last = sqrt(dot(q, q) - 0.01);
  constexpr auto angle = atan2(magnitude(cross(p, q)), dot(p, q)) - atan2(first, 0.1) - atan2(last, 0.1);
  constexpr auto around = if_positive(angle, first + last + 0.1 * angle, magnitude(p - q));
  expect_same_motion<arm<linear_spring<around_sphere<P, 0.1, Q, Wall>, k, 0.2>>,
                     arm<potential_energy<k * pow(around - 0.2, 2) / 2>>>();
  // along z, a cylinder and a sphere have equal sections
  struct Level : offset<Level, P, q3 * N::x + 0.2 * A::y> {};
  struct Post : offset<Post, P, -0.3 * N::x - 0.2 * N::y> {};
  constexpr auto round = magnitude(cross(position_of<Level, P>, position_of<Post, P>));
  expect_same_motion<
      arm<force_along<around_sphere<P, 0.1, Level, Post>, F>>,
      arm<force_along<around_cylinder<A, P, 2 * N::z, 0.1, Level, Post, wrapping::counterclockwise>,
                      F * smooth_step(dot(cross(position_of<Level, P>, position_of<Post, P>), N::z) / round,
                                      0, 0.1)>,
          force_along<around_cylinder<A, P, A::z, 0.1, Level, Post, wrapping::clockwise>,
                      F * smooth_step(-dot(cross(position_of<Level, P>, position_of<Post, P>), N::z) / round,
                                      0, 0.1)>>>();
}

TEST(loads, of_motion_that_is_prescribed_or_auxiliary) {
  constexpr auto v = u3 * Turned::x + (u1 + dot(theta)) * q3 * Turned::y;
  expect_equal((carried_motion<
                   force<Carrier, -c * velocity_of<Carrier> + c * magnitude(velocity_of<Carrier>) * N::z>>()),
               (carried_motion<force<Carrier, -c * v + c * magnitude(v) * N::z>>()));
}

namespace {

/// A system with additional loads.
template <class System, class... More>
struct loaded;
template <class... Words, class... More>
struct loaded<kane_system<Words...>, More...> : kane_system<Words..., loads<More...>> {};

template <class... Loads>
using linkage =
    loaded<kane_system<inertial<four_bar::N>, coordinates<four_bar::q1, four_bar::q2, four_bar::q3>,
                       speeds<four_bar::u1, four_bar::u2, four_bar::u3>,
                       kinematics<dot(four_bar::q1) == four_bar::u1, dot(four_bar::q2) == four_bar::u2,
                                  dot(four_bar::q3) == four_bar::u3>,
                       configuration_constraints<zero_along<position_of<four_bar::P3, four_bar::Bearing>,
                                                            four_bar::N::x, four_bar::N::y>>,
                       bodies<four_bar::Crank, four_bar::Coupler, four_bar::Rocker>>,
           Loads...>;

template <class... Loads>
using string_pendulum = loaded<
    kane_system<inertial<pendulum_nonminimal::N>,
                coordinates<pendulum_nonminimal::q1, pendulum_nonminimal::q2>,
                speeds<pendulum_nonminimal::u1, pendulum_nonminimal::u2>,
                kinematics<dot(pendulum_nonminimal::q1) == pendulum_nonminimal::u1,
                           dot(pendulum_nonminimal::q2) == pendulum_nonminimal::u2>,
                configuration_constraints<pendulum_nonminimal::q1 * pendulum_nonminimal::q1 +
                                              pendulum_nonminimal::q2 * pendulum_nonminimal::q2 ==
                                          pendulum_nonminimal::L * pendulum_nonminimal::L>,
                parameters<pendulum_nonminimal::m, pendulum_nonminimal::L>, bodies<pendulum_nonminimal::Bob>>,
    Loads...>;

} // namespace

TEST(loads, of_systems_with_constraints) {
  using four_bar::G2;
  using four_bar::G3;
  constexpr auto apart = position_of<G3, four_bar::O>;
  constexpr auto stiff = constant<3, units::si::newton / units::si::meter>;
  constexpr auto viscous = constant<0.7, units::si::newton * units::si::second / units::si::meter>;
  constexpr auto twisting = constant<0.4, units::si::newton * units::si::meter * units::si::second>;
  constexpr auto pull = -stiff * (magnitude(apart) - 0.2) * normalized(apart);
  constexpr auto q = four_bar::u1 + four_bar::u2;
  constexpr auto v = four_bar::l1 * four_bar::u1 * four_bar::A::y + four_bar::d2 * q * four_bar::B::y;
  using first = linkage<spring<G3, four_bar::O, 3, 0.2>, force<G2, -viscous * velocity_of<G2>>,
                        torsional_damper<four_bar::C, four_bar::B, 0.4>>;
  using second = linkage<force_between<G3, four_bar::O, pull>, force<G2, -viscous * v>,
                         torque_between<four_bar::C, four_bar::B, -twisting * four_bar::u3 * four_bar::N::z>>;
  using mechanics::quantity;
  expect_equal(numbers<first>(13, 0.4, quantity::udot, quantity::multipliers, quantity::forcing),
               numbers<second>(13, 0.4, quantity::udot, quantity::multipliers, quantity::forcing));

  using bob = pendulum_nonminimal::P;
  constexpr auto swing = pendulum_nonminimal::u1 * pendulum_nonminimal::N::x +
                         pendulum_nonminimal::u2 * pendulum_nonminimal::N::y;
  struct Hook : offset<Hook, pendulum_nonminimal::O, 0.3 * pendulum_nonminimal::N::y> {};
  using third = string_pendulum<spring<bob, Hook, 3, 0.2>, force<bob, -viscous * velocity_of<bob>>>;
  constexpr auto string = position_of<bob, Hook>;
  using fourth =
      string_pendulum<force<bob, -stiff*(magnitude(string) - 0.2) * normalized(string) - viscous * swing>>;
  expect_equal(numbers<third>(2, 0.4, quantity::udot, quantity::multipliers, quantity::active_forces),
               numbers<fourth>(2, 0.4, quantity::udot, quantity::multipliers, quantity::active_forces));
}
