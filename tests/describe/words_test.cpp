// builds: clang++ sanitize
// Different words for the same model give the same equations. The systems are derived at run time, because
// only the reading is compared.
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

/// A body in frame B, suspended at O by a pendulum arm, with the words to be compared.
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
struct any_axis : rotated<any_axis, A2, q3, +(2 * A2::x)> {};
struct against : rotated<against, A2, -q3, -A2::x> {};
struct cosines : direction_cosines<cosines, A2, 1, 0, 0, 0, cos(q3), -sin(q3), 0, sin(q3), cos(q3)> {};
struct halves : quaternion<halves, A2, cos(q3 / 2), sin(q3 / 2), 0, 0> {};
struct declared : rotated<declared, A2, q3, A2::x>,
                  angular_velocity<N, u1 * N::z + u2 * A1::y + u3 * own::x> {};

} // namespace

// Beyond the largest signed integer.
static_assert(describe::constant(18446744073709551615u).tokens[0].number.value() > 1.8e19);

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
struct stepped_center : offset<stepped_center, Step, 0.3 * A3::y>, velocity<A3, 0.0 * A3::x> {};

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
// I about O is I about the center plus m (r·r E − r r) with r = l x + 0.3 y
using about_pivot = inertia_about<
    O, inertia<A3, I + 0.09 * m, 2 * I + m * l * l, 3 * I + m*(l* l + 0.09), 0.1 - 0.3 * m * l, 0.2, 0.3>>;
// A2.x is A3.x: a sum over two frames
using two_frames =
    inertia_dyadic<I * outer(A2::x, A2::x) + 2 * I * outer(A3::y, A3::y) + 3 * I * outer(A3::z, A3::z) +
                   0.1 * (outer(A2::x, A3::y) + outer(A3::y, A3::x)) +
                   0.2 * (outer(A3::y, A3::z) + outer(A3::z, A3::y)) +
                   0.3 * (outer(A3::z, A2::x) + outer(A3::x, A3::z))>;
using other_signs =
    inertia_dyadic<outer(A3::x, A3::x) * 2 * I / 2 - (-2 * I * outer(A3::y, A3::y)) -
                   (-outer(A3::z, A3::z)) * (3 * I) + (outer(A3::x, A3::y) + outer(A3::y, A3::x)) / 10 +
                   0.4 * I*(outer(A3::y, A3::z) + outer(A3::z, A3::y)) / (2 * I) +
                   0.3 * (outer(A3::z, A3::x) + outer(A3::x, A3::z))>;

} // namespace

TEST(words, inertias) {
  expect_same_motion<chain, hanging<A3, G<A3>, dyads>::System>();
  expect_same_motion<chain, hanging<A3, G<A3>, about_pivot>::System>();
  expect_same_motion<chain, hanging<A3, G<A3>, two_frames>::System>();
  expect_same_motion<chain, hanging<A3, G<A3>, other_signs>::System>();
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
struct numbers_first
    : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>, parameters<m, l, I>,
                  kinematics<0 == dot(q1) - u1, 2 == 2 + u2 - dot(q2), 0.0 == u3 - dot(q3)>, bodies<Body>,
                  own_loads> {};

} // namespace

TEST(words, systems) {
  expect_same_motion<chain, bound>(); // in another order, with numbers in the type
  expect_same_motion<chain, coupled>();
  expect_same_motion<chain, numbers_first>();
}

TEST(words, scalar_functions) {
  auto derived =
      derive<chain, sqrt(l) + asin(q1 / 4) * acos(q2 / 4) - atan(q3) + atan2(q1, q2) * exp(-q1) + log(l) +
                        abs(q2) * sign(q3) + pow(l, 3) + pow(l, q1) + pow(2, q1) + atan2(q1, 3) +
                        atan2(2, q2) + rational<1, 3> * tan(q1) + cbrt(q2) * erf(q1) + wrap_to_pi(9 * q1)>();
  auto f = derived.function(
      derived.get<sqrt(l) + asin(q1 / 4) * acos(q2 / 4) - atan(q3) + atan2(q1, q2) * exp(-q1) + log(l) +
                  abs(q2) * sign(q3) + pow(l, 3) + pow(l, q1) + pow(2, q1) + atan2(q1, 3) + atan2(2, q2) +
                  rational<1, 3> * tan(q1) + cbrt(q2) * erf(q1) + wrap_to_pi(9 * q1)>());
  const double a = 0.3, b = -0.8, c = -1.1, length = 0.7;
  Eigen::VectorXd x(6);
  x << a, b, c, 0, 0, 0;
  EXPECT_NEAR(f(x, Eigen::Vector3d(1, length, 1))(0),
              std::sqrt(length) + std::asin(a / 4) * std::acos(b / 4) - std::atan(c) +
                  std::atan2(a, b) * std::exp(-a) + std::log(length) - std::abs(b) + std::pow(length, 3) +
                  std::pow(length, a) + std::pow(2, a) + std::atan2(a, 3) + std::atan2(2, b) +
                  std::tan(a) / 3 + std::cbrt(b) * std::erf(a) + std::remainder(9 * a, 2 * std::acos(-1.0)),
              1e-14);
}

namespace {

constexpr coordinate<"e0"> e0;
constexpr coordinate<"e1"> e1;
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;

/// A body with the components of its angular velocity in its own axes as generalized speeds.
template <class B, class Coordinates, auto... equations>
struct turning {
  struct Center : offset<Center, O, l * B::x + 0.3 * B::y> {};
  struct Body : rigid_body<Body, Center, B, m, inertia<B, I, 2 * I, 3 * I>> {};
  struct System : kane_system<inertial<N>, Coordinates, speeds<u1, u2, u3>, parameters<m, l, I>,
                              kinematics<equations...>, bodies<Body>, loads<gravity<-9.81 * N::z>>> {};
};

using three_angles = coordinates<q1, q2, q3>;
using own_speeds = angular_velocity<N, u1 * own::x + u2 * own::y + u3 * own::z>;

struct angles : body_fixed<angles, N, "zxz", q1, q2, q3>, own_speeds {};
struct space : space_fixed<space, N, "xyz", q1, q2, q3>, own_speeds {};
struct Y : rotated<Y, N, q1, N::z> {};
struct L : rotated<L, Y, q2, Y::x> {};
struct R : rotated<R, L, q3, L::y>, angular_velocity<N, u1 * L::x + u2 * L::y + u3 * L::z> {};
struct parameters_of_euler : quaternion<parameters_of_euler, N, e0, e1, e2, e3>, own_speeds {};

} // namespace

TEST(words, kinematics_of_frames) {
  expect_same_motion<turning<angles, three_angles, sin(q2) * dot(q1) == sin(q3) * u1 + cos(q3) * u2,
                             dot(q2) == cos(q3) * u1 - sin(q3) * u2,
                             dot(q3) == u3 - cos(q2) / sin(q2) * (sin(q3) * u1 + cos(q3) * u2)>::System,
                     turning<angles, three_angles, kinematics_of<angles, N>>::System>();
  expect_same_motion<turning<space, three_angles, dot(q1) == u1 + tan(q2) * (sin(q1) * u2 + cos(q1) * u3),
                             dot(q2) == cos(q1) * u2 - sin(q1) * u3,
                             dot(q3) == (sin(q1) * u2 + cos(q1) * u3) / cos(q2)>::System,
                     turning<space, three_angles, kinematics_of<space, N>>::System>();
  expect_same_motion<
      turning<R, three_angles, dot(q1) == u3 / cos(q2), dot(q2) == u1, dot(q3) == u2 - u3 * tan(q2)>::System,
      turning<R, three_angles, kinematics_of<R, N>>::System>();
  using unit_quaternion = coordinates<e0, e1, e2, e3>;
  expect_same_motion<
      turning<parameters_of_euler, unit_quaternion, dot(e0) == -(e1 * u1 + e2 * u2 + e3 * u3) / 2,
              dot(e1) == (e0 * u1 + e2 * u3 - e3 * u2) / 2, dot(e2) == (e0 * u2 + e3 * u1 - e1 * u3) / 2,
              dot(e3) == (e0 * u3 + e1 * u2 - e2 * u1) / 2>::System,
      turning<parameters_of_euler, unit_quaternion, kinematics_of<parameters_of_euler, N>>::System>();
}

namespace {

constexpr speed<"ua"> ua;
constexpr prescribed<"theta"> theta;
constexpr prescribed<"swing", 2> swing2;

struct Slider : offset<Slider, O, q1 * N::x>, velocity<N, u1 * N::x + ua * N::z> {};
struct Arm : rotated<Arm, N, q2, N::y> {};
struct Tip : offset<Tip, Slider, l * Arm::x> {};
struct Ball : particle<Ball, Tip, m> {};

using own_words = kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, auxiliary<ua>,
                              kinematics<dot(q1) == u1, dot(q2) == u2>, bodies<Ball>>;

/// The same system with additional words.
template <class Words, class... More>
struct with;
template <class... Words, class... More>
struct with<kane_system<Words...>, More...> : kane_system<Words..., More...> {};

struct constrained
    : with<own_words,
           configuration_constraints<q1 * q1 == l * l, zero_along<position_of<Tip, O>, N::x, 2 * N::z>>,
           velocity_constraints<zero_along<velocity_of<Tip>, N::x, Arm::x + N::z>, u1 == u2 + ua>,
           acceleration_constraints<dot(u1) + dot(u2) == 0>, dependent<u2, q1>> {};

template <class System>
struct reading {
  symbolic::graph graph;
  mechanics::multibody_system system{graph};
  const mechanics::mechanism& m = system.mechanism;
  const mechanics::given_constraints& c = system.constraints;
  derivation::reader reader{System::record, system};
  reading() { reader.read(); }
  std::string print(symbolic::expression e) const { return symbolic::print(e); }
  std::string inputs() const {
    std::string all;
    for (const symbolic::expression& e : m.inputs) all += symbolic::print(e) + " ";
    for (const mechanics::prescribed_rate& p : m.prescribed_rates)
      all += symbolic::print(p.quantity) + "->" + symbolic::print(p.rate) + " ";
    return all;
  }
};

} // namespace

TEST(words, constraints) {
  reading<constrained> r;
  ASSERT_EQ(r.reader.mistake().view(), "");
  mechanics::known_motion known(r.m);
  r.reader.set_known_motion(known);
  r.reader.read_constraints();
  ASSERT_EQ(r.reader.mistake().view(), "");
  ASSERT_EQ(r.c.on_configuration.size(), 3);
  EXPECT_EQ(r.print(r.c.on_configuration[0]), "q1^2 - l^2");
  EXPECT_EQ(r.print(r.c.on_configuration[1]), "l*cos(q2) + q1");
  EXPECT_EQ(r.print(r.c.on_configuration[2]), "-2*l*sin(q2)");
  ASSERT_EQ(r.c.on_velocities.size(), 3);
  EXPECT_EQ(r.c.on_velocities[0].vanishing.parts.size(), 1);
  EXPECT_EQ(r.c.on_velocities[1].direction.parts.size(), 2);
  EXPECT_TRUE(r.c.on_velocities[2].vanishing.parts.empty());
  EXPECT_EQ(r.print(r.c.on_velocities[2].value), "u1 - u2 - ua");
  ASSERT_EQ(r.c.on_accelerations.size(), 1);
  EXPECT_EQ(r.print(r.c.on_accelerations[0]), "u1' + u2'");
  ASSERT_EQ(r.c.dependent_speeds.size(), 1);
  EXPECT_EQ(r.c.dependent_speeds[0], 1);
  ASSERT_EQ(r.c.dependent_coordinates.size(), 1);
  EXPECT_EQ(r.c.dependent_coordinates[0], 0);
  ASSERT_EQ(r.m.auxiliary_speeds.size(), 1);
}

TEST(words, prescribed_quantities) {
  using moved = loads<force<Tip, dot(swing2) * N::x>>;
  EXPECT_EQ((reading<with<own_words, moved>>().inputs()),
            "swing2 swing2' swing2'' swing2->swing2' swing2'->swing2'' ");
  EXPECT_EQ((reading<with<own_words, inputs<dot(swing2), theta, swing2>, moved>>().inputs()),
            "swing2' theta swing2 swing2->swing2' ");
}

TEST(words, prescribed_quantities_by_name) {
  struct System : with<own_words, loads<force<Tip, (theta + dot(swing2)) * N::x>>> {};
  input_values<System> r;
  ASSERT_EQ(r.size(), 6);
  r[theta] = 1, r[dot(theta)] = 2, r[dot(dot(theta))] = 3;
  r[swing2] = 4, r[dot(swing2)] = 5, r[dot(dot(swing2))] = 6;
  const input_values<System>& kept = r;
  for (int i = 0; i < 6; ++i) EXPECT_EQ(r(i), i + 1);
  EXPECT_EQ(kept[dot(swing2)], 5);
}

namespace {

struct apart : rotated<apart, A2, q3, A2::x>, angular_velocity_apart_from_orientation<A2, 2 * u3 * own::x> {};
struct a_body_whose_name_is_longer_than_a_piece_of_a_sentence
    : particle<a_body_whose_name_is_longer_than_a_piece_of_a_sentence, O, 0.0 * m> {};

} // namespace

// Mistakes in other models, declared as intentional here.
TEST(words, on_purpose) {
  using rotor = hanging<A3, G<A3>, usual<A2>>::System;
  EXPECT_EQ(derive<rotor>().mistake(),
            "the inertia of Body is given along the axes of A2 and changes as seen from A3, the body frame; "
            "if this is intended, write changing_inertia<...>");
  using changing_rotor = hanging<A3, G<A3>, changing_inertia<usual<A2>>>::System;
  EXPECT_EQ(derive<changing_rotor>().mistake(), "");
  using given_elsewhere = hanging<A3, G<A3>, inertia_about<O, changing_inertia<usual<A2>>>>::System;
  EXPECT_EQ(derive<given_elsewhere>().mistake(), "");
  using turning_apart = hanging<apart, G<apart>, usual<apart>>::System;
  EXPECT_EQ(derive<turning_apart>().mistake(), "");
}

// clang shows about thirty characters in one piece.
TEST(words, are_shown_in_pieces_that_lose_no_letter) {
  using named = kane_system<inertial<N>, coordinates<q1>, speeds<u1>, kinematics<dot(q1) == u1>,
                            bodies<a_body_whose_name_is_longer_than_a_piece_of_a_sentence>>;
  static constexpr base::sentence told = derivation::stages_of<named>::constrained.mistake;
  std::string whole(told.view()), shown;
  EXPECT_EQ(whole, "body a_body_whose_name_is_longer_than_a_piece_of_a_sentence has no mass");
  for (int piece = 0; piece < derivation::count_pieces(told); ++piece) {
    const int begin = derivation::piece_begin(told, piece), end = derivation::piece_end(told, begin);
    EXPECT_LE(end - begin, derivation::longest_piece);
    shown += told.view().substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
  }
  std::erase(whole, ' '), std::erase(shown, ' ');
  EXPECT_EQ(shown, whole);
}
