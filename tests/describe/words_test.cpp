// builds: sanitize
// Different words for the same thing give the same equations. Derived at run time: what is compared is the
// reading.
#include <kanexpr/symbolic.hpp>

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
constexpr parameter<"I"> I;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};

/// A body in frame B that hangs at O by a pendulum arm, with the words that are to be compared.
template <class B, class Center, class Inertia, class... More>
struct hanging {
  struct Body : rigid_body<Body, Center, B, m, Inertia> {};
  struct System
      : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                    kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3>, parameters<m, l, I>,
                    bodies<Body>, loads<gravity<-9.81 * N::z>, force<Center, 3 * N::x>, torque<B, q1 * B::y>>,
                    More...> {};
};

template <class B>
struct G : offset<G<B>, O, l * B::x + 0.3 * B::y> {};

template <class B>
using usual = inertia<B, I, 2 * I, 3 * I, 0.1, 0.2, 0.3>;

/// q̇ and u̇ at some states.
template <class System>
Eigen::MatrixXd motion() {
  auto derived = derive<System>();
  EXPECT_EQ(derived.mistake(), "");
  auto rhs = derived.function(derived.rhs());
  std::mt19937_64 source(5);
  std::uniform_real_distribution<double> values(0.4, 1.2);
  Eigen::MatrixXd rates(derived.rhs().rows, 8);
  const Eigen::Vector3d p(1.4, 0.7, 2.5);
  for (Eigen::Index i = 0; i < rates.cols(); ++i) {
    Eigen::VectorXd x(derived.rhs().rows);
    for (double& value : x) value = values(source);
    rates.col(i) = rhs(x, p, p);
  }
  return rates;
}

template <class First, class Second>
void expect_same_motion() {
  const Eigen::MatrixXd first = motion<First>(), second = motion<Second>();
  EXPECT_LT((first - second).cwiseAbs().maxCoeff(), 1e-12 * first.cwiseAbs().maxCoeff());
}

struct A1 : rotated<A1, N, q1, N::z> {};
struct A2 : rotated<A2, A1, q2, A1::y> {};
struct A3 : rotated<A3, A2, q3, A2::x> {};
using chain = hanging<A3, G<A3>, usual<A3>>::System;

struct body_sequence : body_fixed<body_sequence, N, "zyx", q1, q2, q3> {};
struct body_digits : body_fixed<body_digits, N, "321", q1, q2, q3> {};
struct space_sequence : space_fixed<space_sequence, N, "xyz", q3, q2, q1> {};
struct any_axis : rotated<any_axis, A2, q3, 2 * A2::x> {};
struct against : rotated<against, A2, -q3, -A2::x> {};
struct cosines : direction_cosines<cosines, A2, 1, 0, 0, 0, cos(q3), -sin(q3), 0, sin(q3), cos(q3)> {};
struct halves : quaternion<halves, A2, cos(q3 / 2), sin(q3 / 2), 0, 0> {};
struct declared : rotated<declared, A2, q3, A2::x>,
                  angular_velocity<N, u1 * N::z + u2 * A1::y + u3 * own::x> {};

} // namespace

TEST(words, orientations) {
  expect_same_motion<chain, hanging<body_sequence, G<body_sequence>, usual<body_sequence>>::System>();
  expect_same_motion<chain, hanging<body_digits, G<body_digits>, usual<body_digits>>::System>();
  expect_same_motion<chain, hanging<space_sequence, G<space_sequence>, usual<space_sequence>>::System>();
  expect_same_motion<chain, hanging<any_axis, G<any_axis>, usual<any_axis>>::System>();
  expect_same_motion<chain, hanging<against, G<against>, usual<against>>::System>();
  expect_same_motion<chain, hanging<cosines, G<cosines>, usual<cosines>>::System>();
  expect_same_motion<chain, hanging<halves, G<halves>, usual<halves>>::System>();
  expect_same_motion<chain, hanging<declared, G<declared>, usual<declared>>::System>();
}

namespace {

struct fixed_center : offset<fixed_center, O, l * A3::x + 0.3 * A3::y>, fixed_in<A3> {};
struct given_center : offset<given_center, O, l * A3::x + 0.3 * A3::y>,
                      velocity<N, cross(u1* N::z + u2 * A1::y + u3 * A2::x, l* A3::x + 0.3 * A3::y)> {};
struct Step : offset<Step, O, l * A3::x> {};
struct stepped_center : offset<stepped_center, Step, 0.3 * A3::y>, velocity<A3, 0 * A3::x> {};

} // namespace

TEST(words, velocities) {
  expect_same_motion<chain, hanging<A3, fixed_center, usual<A3>>::System>();
  expect_same_motion<chain, hanging<A3, given_center, usual<A3>>::System>();
  expect_same_motion<chain, hanging<A3, stepped_center, usual<A3>>::System>();
}

namespace {

using dyads = inertia_dyadic<I * outer(A3::x, A3::x) + 2 * I * outer(A3::y, A3::y) +
                             3 * I * outer(A3::z, A3::z) + 0.1 * (outer(A3::x, A3::y) + outer(A3::y, A3::x)) +
                             0.2 * (outer(A3::y, A3::z) + outer(A3::z, A3::y)) +
                             0.3 * (outer(A3::z, A3::x) + outer(A3::x, A3::z))>;
// I about O is I about the centre and m (r·r E − r r) with r = l x + 0.3 y
using about_pivot = inertia_about<
    O, inertia<A3, I + 0.09 * m, 2 * I + m * l * l, 3 * I + m*(l* l + 0.09), 0.1 - 0.3 * m * l, 0.2, 0.3>>;
// A2.x is A3.x: a sum over two frames
using two_frames =
    inertia_dyadic<I * outer(A2::x, A2::x) + 2 * I * outer(A3::y, A3::y) + 3 * I * outer(A3::z, A3::z) +
                   0.1 * (outer(A2::x, A3::y) + outer(A3::y, A3::x)) +
                   0.2 * (outer(A3::y, A3::z) + outer(A3::z, A3::y)) +
                   0.3 * (outer(A3::z, A2::x) + outer(A3::x, A3::z))>;

} // namespace

TEST(words, inertias) {
  expect_same_motion<chain, hanging<A3, G<A3>, dyads>::System>();
  expect_same_motion<chain, hanging<A3, G<A3>, about_pivot>::System>();
  expect_same_motion<chain, hanging<A3, G<A3>, two_frames>::System>();
}

namespace {

struct Body : rigid_body<Body, G<A3>, A3, m, usual<A3>> {};
using own_loads = loads<gravity<-9.81 * N::z>, force<G<A3>, 3 * N::x>, torque<A3, q1 * A3::y>>;
using own_kinematics = kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3>;

struct bound : kane_system<own_loads, values<m == 1.4, l == 0.7, I == 2.5>, own_kinematics, bodies<Body>,
                           speeds<u1, u2, u3>, coordinates<q1, q2, q3>, inertial<N>> {};
struct coupled : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>, parameters<m, l, I>,
                             kinematics<u1 + 2 * u2 == dot(q1) + 2 * dot(q2), u2 - u1 == dot(q2) - dot(q1),
                                        3 * u3 == 3 * dot(q3)>,
                             bodies<Body>, own_loads> {};

} // namespace

TEST(words, systems) {
  expect_same_motion<chain, bound>(); // in another order, with numbers in the type
  expect_same_motion<chain, coupled>();
}

TEST(words, scalar_functions) {
  auto derived =
      derive<chain, sqrt(l) + asin(q1 / 4) * acos(q2 / 4) - atan(q3) + atan2(q1, q2) * exp(-q1) + log(l) +
                        abs(q2) * sign(q3) + pow(l, 3) + pow(l, q1) + rational<1, 3> * tan(q1)>();
  auto f = derived.function(
      derived.get<sqrt(l) + asin(q1 / 4) * acos(q2 / 4) - atan(q3) + atan2(q1, q2) * exp(-q1) + log(l) +
                  abs(q2) * sign(q3) + pow(l, 3) + pow(l, q1) + rational<1, 3> * tan(q1)>());
  const double a = 0.3, b = -0.8, c = -1.1, length = 0.7;
  Eigen::VectorXd x(6);
  x << a, b, c, 0, 0, 0;
  EXPECT_NEAR(f(x, Eigen::Vector3d(1, length, 1))(0),
              std::sqrt(length) + std::asin(a / 4) * std::acos(b / 4) - std::atan(c) +
                  std::atan2(a, b) * std::exp(-a) + std::log(length) - std::abs(b) + std::pow(length, 3) +
                  std::pow(length, a) + std::tan(a) / 3,
              1e-14);
}
