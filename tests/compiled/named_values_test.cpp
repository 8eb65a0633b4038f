// builds: clang++ sanitize no-exceptions
// Values given by name: where they are stored, and mistakes in them.
#include "models/bicycle.hpp"
#include "models/four_bar.hpp"

#include <kanexpr/compiled/named_values.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace {

using kanexpr::dot;
using kanexpr::named_value;
using given_state = kanexpr::given_state<four_bar::System>;
using given_parameters = kanexpr::given_parameters<four_bar::System>;
using given_inputs = kanexpr::given_inputs<four_bar::System>;
using bicycle_state = kanexpr::given_state<bicycle::BoundSystem>;
using bicycle_parameters = kanexpr::given_parameters<bicycle::BoundSystem>;

// as a function argument, given in braces
kanexpr::state<four_bar::System> taken(const given_state& x) {
  EXPECT_EQ(x.mistake.view(), "");
  return x.values;
}

std::string mistake_of(const given_state& x) { return std::string(x.mistake.view()); }
std::string mistake_of_parameters(const given_parameters& p) { return std::string(p.mistake.view()); }

TEST(named_values, come_in_any_order) {
  using namespace four_bar;
  Eigen::Matrix<double, 6, 1> expected;
  expected << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  EXPECT_EQ(taken({{u3, 0.6}, {q1, 0.1}, {u1, 0.4}, {q3, 0.3}, {q2, 0.2}, {u2, 0.5}}), expected);
  EXPECT_EQ(taken({{"u3", 0.6}, {q1, 0.1}, {"u1", 0.4}, {q3, 0.3}, {q2, 0.2}, {u2, 0.5}}), expected);
  EXPECT_EQ(taken(expected), expected);
  EXPECT_EQ(taken(2 * kanexpr::state<System>(expected) - expected), expected);
  EXPECT_EQ(taken(Eigen::VectorXd(expected)), expected);
}

TEST(named_values, come_from_a_list_or_a_file) {
  using namespace four_bar;
  std::map<std::string, double> file;
  std::vector<named_value> list;
  kanexpr::parameter_values<System> expected;
  const char* const names[]{"m3", "g",  "l1", "d1", "l0", "m1", "l3",
                            "m2", "I2", "I1", "l2", "d2", "I3", "d3"};
  double value = 0.1;
  for (const char* name : names) file[name] = value, list.push_back({name, value}), value += 0.37;
  expected[m3] = 0.1, expected[g] = 0.47, expected[l1] = 0.84, expected[d1] = 1.21, expected[l0] = 1.58;
  expected[m1] = 1.95, expected[l3] = 2.32, expected[m2] = 2.69, expected[I2] = 3.06, expected[I1] = 3.43;
  expected[l2] = 3.8, expected[d2] = 4.17, expected[I3] = 4.54, expected[d3] = 4.91;
  const given_parameters by_file = file, by_list = list;
  EXPECT_EQ(by_file.mistake.view(), "");
  EXPECT_EQ(by_list.mistake.view(), "");
  EXPECT_LE((by_file.values - expected).norm(), 1e-14);
  EXPECT_EQ(by_list.values, by_file.values);
}

TEST(named_values, may_leave_out_what_depends) {
  using namespace four_bar;
  const auto x = taken({{q1, 0.1}, {u1, 0.4}, {q3, -1}});
  EXPECT_EQ(x[q3], -1);
  EXPECT_EQ(x[q2], 0);
  const bicycle_state straight{{bicycle::q1, 0}, {bicycle::q2, 0}, {bicycle::q5, 0},
                               {bicycle::u2, 0}, {bicycle::u3, 1}, {bicycle::u5, 0}};
  EXPECT_EQ(straight.mistake.view(), "");
  EXPECT_EQ(bicycle_parameters().mistake.view(), "");
}

TEST(named_values, are_missing) {
  using namespace four_bar;
  EXPECT_EQ(mistake_of({{q1, 0.1}}), "speed u1 has no value");
  EXPECT_EQ(mistake_of({{u1, 0.1}, {q2, 1}}), "coordinate q1 has no value");
  EXPECT_EQ(mistake_of_parameters({}), "parameter m1 has no value");
  EXPECT_EQ(given_inputs().mistake.view(), "input T has no value");
  EXPECT_EQ(given_inputs({{T, 1}}).mistake.view(), "");
  EXPECT_EQ(kanexpr::given_state<LagrangeSystem>({{q1, 1}}).mistake.view(),
            "the rate of coordinate q1 has no value");
  EXPECT_EQ(kanexpr::given_state<LagrangeSystem>({{q1, 1}, {dot(q1), 2}}).values[dot(q1)], 2);
  EXPECT_EQ(kanexpr::given_state<LagrangeSystem>({{q1, 1}, {"q1'", 2}}).mistake.view(), "");
}

TEST(named_values, were_never_set) {
  using namespace four_bar;
  kanexpr::parameter_values<System> p;
  EXPECT_EQ(mistake_of_parameters(p), "parameter m1 has no value");
  p.setOnes();
  EXPECT_EQ(mistake_of_parameters(p), "");
  EXPECT_EQ(given_inputs(kanexpr::input_values<System>()).mistake.view(), "input T has no value");
  EXPECT_EQ(mistake_of(kanexpr::state<System>{{q1, 0.1}}), "speed u1 has no value");
  EXPECT_EQ(mistake_of(kanexpr::state<System>{{q1, 0.1}, {u1, 1}}), ""); // the others are dependent
  EXPECT_EQ(mistake_of(kanexpr::state<System>{{q1, 0.1}, {u1, 1}, {q1, 0.1}}),
            "coordinate q1 has two values");
  EXPECT_EQ(kanexpr::guessed_inputs<System>().values[T], 0);
}

TEST(named_values, are_doubled) {
  using namespace four_bar;
  EXPECT_EQ(mistake_of({{q1, 0.1}, {u1, 1}, {"q1", 0.1}}), "coordinate q1 has two values");
  EXPECT_EQ(mistake_of_parameters({{m1, 1}, {l1, 2}, {m1, 1}}), "parameter m1 has two values");
}

TEST(named_values, are_unknown_or_elsewhere) {
  using namespace four_bar;
  constexpr kanexpr::parameter<"mm"> mm;
  EXPECT_EQ(mistake_of_parameters({{mm, 1}}), "the system System has no parameter mm");
  EXPECT_EQ(mistake_of({{q1, 0.1}, {"q7", 1}}), "the system System has no coordinate or speed q7");
  EXPECT_EQ(mistake_of({{q1, 0.1}, {m1, 1}}), "parameter m1 is not an entry of the state vector of System");
  EXPECT_EQ(mistake_of({{dot(q1), 1}}), "the system System has no coordinate or speed q1'");
  EXPECT_EQ(mistake_of({{kanexpr::rational<1, 2>, 1}}),
            "a value is assigned to an expression that is not a symbol");
  EXPECT_EQ(bicycle_parameters({{bicycle::g, 9}}).mistake.view(),
            "parameter g is already bound in the system BoundSystem");
}

TEST(named_values, are_no_numbers) {
  using namespace four_bar;
  const double none = std::nan(""), huge = std::numeric_limits<double>::infinity();
  EXPECT_EQ(mistake_of({{q1, none}, {u1, 0}}), "the value of coordinate q1 is not a number");
  EXPECT_EQ(mistake_of({{q1, 1}, {u1, 0}, {u3, -huge}}), "the value of speed u3 is infinite");
  kanexpr::state<System> x;
  x[u2] = none;
  EXPECT_EQ(mistake_of(x), "the value of speed u2 is not a number");
  EXPECT_EQ(mistake_of(Eigen::VectorXd::Zero(5)), "the state vector of System has 6 entries, not 5");
}

TEST(named_values, give_no_body_a_negative_mass) {
  using namespace four_bar;
  kanexpr::parameter_values<System> p = kanexpr::parameter_values<System>::Ones();
  EXPECT_EQ(mistake_of_parameters(p), "");
  p[I2] = -1;
  EXPECT_EQ(mistake_of_parameters(p), "parameter I2, a moment of inertia, is negative");
  p[m1] = -2;
  EXPECT_EQ(mistake_of_parameters(p), "parameter m1, the mass of a body, is negative");
  p[I2] = p[m1] = 0;
  p[l1] = -1; // a length along an axis
  EXPECT_EQ(mistake_of_parameters(p), "");
  EXPECT_EQ(mistake_of_parameters({{l0, 2},
                                   {l1, 1},
                                   {l2, 2},
                                   {l3, 1},
                                   {d1, 1},
                                   {d2, 1},
                                   {d3, 1},
                                   {m1, 1},
                                   {m2, -2},
                                   {m3, 1},
                                   {I1, 1},
                                   {I2, 1},
                                   {I3, 1},
                                   {g, 9.81}}),
            "parameter m2, the mass of a body, is negative");
}

namespace longer_masses {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"l"> l;
constexpr parameter<"rho"> rho;
constexpr parameter<"V"> V;
constexpr parameter<"k"> k;
constexpr parameter<"I"> I;
constexpr parameter<"T"> T;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};
struct Q : offset<Q, P, l * A::x> {};
struct Bob : particle<Bob, P, rho * V> {};
struct Rod : rigid_body<Rod, Q, A, k * l * l + 2, inertia<A, 1, I / 2, I - k * T>> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            parameters<T, l, rho, V, k, I>, bodies<Bob, Rod>> {};

} // namespace longer_masses

TEST(named_values, give_no_body_a_negative_mass_by_an_expression) {
  using namespace longer_masses;
  const auto mistake = [](const kanexpr::given_parameters<System>& p) {
    return std::string(p.mistake.view());
  };
  EXPECT_EQ(mistake({{T, 1}, {l, 1}, {rho, 3}, {V, 2}, {k, 1}, {I, 2}}), "");
  EXPECT_EQ(mistake({{T, 0.1}, {l, -1}, {rho, -3}, {V, -2}, {k, 3}, {I, 0.1 * 3}}), ""); // up to rounding
  EXPECT_EQ(mistake({{T, 1}, {l, 1}, {rho, 3}, {V, -2}, {k, 1}, {I, 2}}), "the mass of Bob is negative");
  EXPECT_EQ(mistake({{T, 1}, {l, 2}, {rho, 3}, {V, 2}, {k, -1}, {I, 2}}), "the mass of Rod is negative");
  EXPECT_EQ(mistake({{T, -1}, {l, 1}, {rho, 3}, {V, 2}, {k, 1}, {I, -0.1}}),
            "a moment of inertia of Rod is negative");
  EXPECT_EQ(mistake({{T, 3}, {l, 1}, {rho, 3}, {V, 2}, {k, 1}, {I, 2}}),
            "a moment of inertia of Rod is negative");
}

namespace inertias {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"Ix"> Ix;
constexpr parameter<"Iy"> Iy;
constexpr parameter<"Iz"> Iz;
constexpr parameter<"Ixy"> Ixy;
constexpr parameter<"m"> m;
constexpr parameter<"r"> r;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, r * A::y> {};
struct Block : rigid_body<Block, P, A, 2, inertia<A, Ix, Iy, Iz, Ixy>> {};
struct Hung : rigid_body<Hung, P, A, m, inertia_about<O, inertia<A, 1, 2, Iz + Ix>>> {};
struct Rotor : rigid_body<Rotor, P, A, 1, effective_inertia<inertia<A, 1, 1, m>>> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            parameters<Ix, Iy, Iz, Ixy, m, r>, bodies<Block, Hung, Rotor>> {};

} // namespace inertias

TEST(named_values, give_no_body_an_inertia_of_none) {
  using namespace inertias;
  const auto mistake = [](double x, double y, double z, double xy, double mass = 1, double arm = 0.5) {
    const kanexpr::given_parameters<System> p{{Ix, x}, {Iy, y}, {Iz, z}, {Ixy, xy}, {m, mass}, {r, arm}};
    return std::string(p.mistake.view());
  };
  const char* const of_none = " is not physical: one principal moment exceeds the sum of the other two; if "
                              "this is intended, wrap it in effective_inertia<...>";
  EXPECT_EQ(mistake(1, 1, 1.2, 0.1), "");
  EXPECT_EQ(mistake(1, 1, 2, 0), ""); // a plate
  EXPECT_EQ(mistake(0, 0, 2, 0), ""); // for planar motion
  EXPECT_EQ(mistake(-1, 1, 1, 0), "parameter Ix, a moment of inertia, is negative");
  EXPECT_EQ(mistake(1, 1, 1, 5),
            "the inertia of Block is indefinite: its moment about some axis is negative");
  EXPECT_EQ(mistake(1, 1, 10, 0), std::string("the inertia of Block") + of_none);
  EXPECT_EQ(mistake(1.2, 1.2, 2, 0), std::string("the inertia of Hung") + of_none);
  EXPECT_EQ(mistake(1, 1, 1, 0, 3, -0.6),
            "the inertia of Hung about O is smaller than the parallel-axis term of its mass");
  EXPECT_EQ(mistake(1, 1, 1, 0, 9, 0.1), ""); // an effective inertia is accepted as given
}

} // namespace
