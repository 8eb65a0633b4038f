// builds: clang++ sanitize
// Linearization at run time: textbook results, merged operating points and their mistakes, and limits.
#include "models/double_pendulum.hpp"
#include "models/four_bar.hpp"
#include "models/pendulum_nonminimal.hpp"
#include "models/rolling_disc.hpp"
#include "models/rotating_tube.hpp"
#include "models/simple_pendulum.hpp"

#include <kanexpr/symbolic.hpp>

#include <gmock/gmock.h>

#include <cmath>

namespace {

using kanexpr::linearization_point;
using kanexpr::symbolic::latex;
using kanexpr::symbolic::print;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(linearization, prints_a_pendulum_as_a_textbook_does) {
  using namespace simple_pendulum;
  auto model = kanexpr::derive<System>();
  auto linear = model.linearize({{q, 0}, {u, 0}, {c, 0}});
  EXPECT_THAT(linear.failures(), IsEmpty());
  EXPECT_EQ(print(linear.explicit_form().A), "[0,    1]\n"
                                             "[-g/l, 0]");
  EXPECT_EQ(print(linear.explicit_form().B), "[0        ]\n"
                                             "[1/(l^2*m)]");
  EXPECT_EQ(latex(linear.explicit_form().A(1, 0)), "-\\frac{g}{l}");
  EXPECT_EQ(print(linear.implicit_form().M), "[1, 0    ]\n"
                                             "[0, l^2*m]");
  EXPECT_EQ(print(linear.implicit_form().A), "[0,      1]\n"
                                             "[-g*l*m, 0]");
  EXPECT_THAT(linear.states(), ElementsAre("q", "u"));
  EXPECT_THAT(linear.inputs(), ElementsAre("T"));
}

// The same by Lagrange's method with the state [q; dq/dt], also with a constraint instead of the angle.
TEST(linearization, prints_the_same_by_lagrange) {
  using namespace simple_pendulum;
  auto angle = kanexpr::derive<LagrangeSystem>();
  auto linear = angle.linearize({{q, 0}, {dot(q), 0}, {c, 0}});
  EXPECT_EQ(print(linear.explicit_form().A), "[0,    1]\n"
                                             "[-g/l, 0]");
  EXPECT_THAT(linear.states(), ElementsAre("q", "q'"));

  namespace string = pendulum_nonminimal;
  auto place = kanexpr::derive<string::LagrangeSystem>();
  auto hanging =
      place.linearize({{string::q1, string::L}, {string::q2, 0}, {dot(string::q1), 0}, {dot(string::q2), 0}});
  EXPECT_THAT(hanging.failures(), IsEmpty());
  EXPECT_EQ(print(hanging.explicit_form().A), "[0,    1]\n"
                                              "[-g/L, 0]");
  EXPECT_EQ(print(hanging.implicit_form().M), "[1, 0, 0, 0,   0   ]\n"
                                              "[0, 1, 0, 0,   0   ]\n"
                                              "[0, 0, 0, 2*L, 0   ]\n"
                                              "[0, 0, m, 0,   0   ]\n"
                                              "[0, 0, 0, m,   -2*L]");
}

// A motor whose torque is written such that it is 0/0 for the hanging pendulum.
namespace undetermined {
using namespace simple_pendulum;
struct System
    : kanexpr::kane_system<
          kanexpr::inertial<N>, kanexpr::coordinates<q>, kanexpr::speeds<u>, kanexpr::kinematics<dot(q) == u>,
          kanexpr::bodies<Bob>,
          kanexpr::loads<kanexpr::gravity<g * N::x>, kanexpr::torque<A, T * sin(q) / tan(q) * N::z>>> {};
} // namespace undetermined

TEST(linearization, takes_limits_where_an_entry_is_undetermined) {
  using namespace simple_pendulum;
  auto model = kanexpr::derive<undetermined::System>();
  auto linear = model.linearize({{q, 0}, {u, 0}});
  EXPECT_EQ(print(linear.explicit_form().A), "[0,    1]\n"
                                             "[-g/l, 0]");
  EXPECT_THAT(linear.failures(), IsEmpty());
  EXPECT_EQ(print(linear.explicit_form().B), "[0        ]\n"
                                             "[1/(l^2*m)]");
}

// A disc that lies flat has no yaw.
TEST(linearization, names_an_entry_without_a_value) {
  using namespace rolling_disc;
  auto model = kanexpr::derive<System>();
  auto flat = model.linearize({{q2, std::acos(0.0)}, {u1, 0}, {u2, 1}, {u3, 1}});
  flat.explicit_form();
  ASSERT_FALSE(flat);
  EXPECT_THAT(flat.failures()[0], HasSubstr("cos(q2)"));
}

TEST(linearization, leaves_symbols_that_the_point_does_not_name) {
  using namespace simple_pendulum;
  auto model = kanexpr::derive<System>();
  EXPECT_EQ(print(model.linearize().explicit_form().A), "[0,           1         ]\n"
                                                        "[-g*cos(q)/l, -c/(l^2*m)]");
  EXPECT_EQ(print(model.linearize({{q, 0}, {"l", 2}}).explicit_form().A), "[0,    1       ]\n"
                                                                          "[-g/2, -c/(4*m)]");
}

// A length that is not in the model, and a value written as an expression of the model.
TEST(linearization, takes_expressions_and_new_parameters) {
  using namespace simple_pendulum;
  constexpr kanexpr::parameter<"f"> f;
  auto model = kanexpr::derive<System>();
  auto linear = model.linearize({{q, 0}, {g, 4 * l * f * f}, {c, 0}});
  EXPECT_EQ(print(linear.explicit_form().A(1, 0)), "-4*f^2");
  Eigen::VectorXd p(5); // m, l, g, c, f
  p << 1, 2, 3, 4, 5;
  auto A = model.function(linear.explicit_form().A);
  EXPECT_EQ(A(Eigen::VectorXd::Zero(2), p)(1, 0), -100);
}

TEST(linearization, merges_sets_of_values) {
  using namespace simple_pendulum;
  auto model = kanexpr::derive<System>();
  const linearization_point upright{{q, 3}, {c, 0}}, short_one{{l, 1}, {q, 0}};
  EXPECT_EQ(print(model.linearize(upright, short_one).explicit_form().A(1, 0)), "-g");
}

TEST(linearization, says_which_equation_a_point_does_not_satisfy) {
  using namespace four_bar;
  auto model = kanexpr::derive<System>();
  linearization_point open{{l0, 2}, {l1, 1}, {l2, 2}, {l3, 2}, {u1, 1}, {u2, 0}, {u3, 0}};
  auto linear = model.linearize(open, {{q1, 0}, {q2, 0}, {q3, 0}});
  ASSERT_FALSE(linear);
  EXPECT_EQ(linear.failures()[0],
            "the operating point does not satisfy configuration constraint 1: the residual is 3");
  EXPECT_THAT(linear.failures(), testing::Contains(HasSubstr("velocity constraint")));
}

TEST(linearization, checks_rates_that_the_point_gives) {
  using namespace simple_pendulum;
  auto model = kanexpr::derive<System>();
  const linearization_point swinging{{q, 0}, {u, 2}, {"T", 0}, {c, 0}, {l, 1}, {m, 1}, {g, 10}};
  EXPECT_TRUE(model.linearize(swinging, {{dot(q), 2}, {dot(u), 0}}));
  auto wrong_rate = model.linearize(swinging, {{dot(q), 3}});
  EXPECT_THAT(
      wrong_rate.failures(),
      ElementsAre(
          "the operating point does not satisfy kinematic differential equation 1: the residual is 1"));
  auto wrong_acceleration = model.linearize(swinging, {{dot(u), 0.5}});
  EXPECT_THAT(
      wrong_acceleration.failures(),
      ElementsAre(
          "the operating point does not satisfy dynamic differential equation 1: the residual is 0.5"));
}

// With symbolic lengths, the point satisfies the constraints only for some lengths.
TEST(linearization, checks_points_whose_parameters_are_open) {
  using namespace pendulum_nonminimal;
  auto model = kanexpr::derive<System>();
  const linearization_point still{{q2, 0}, {u1, 0}, {u2, 0}};
  EXPECT_TRUE(model.linearize(still, {{q1, L}}));
  EXPECT_FALSE(model.linearize(still, {{q1, 1}}));
  EXPECT_EQ(print(model.linearize(still, {{q1, L}}).explicit_form().A), "[0,    1]\n"
                                                                        "[-g/L, 0]");
}

TEST(linearization, says_what_it_does_not_know) {
  using namespace simple_pendulum;
  auto model = kanexpr::derive<System>();
  constexpr kanexpr::coordinate<"x"> x;
  EXPECT_THAT(model.linearize({{x, 1}}).failures(),
              ElementsAre("the operating point refers to x, which the system does not have"));
  const linearization_point doubled{{q, 0}, {u, 0}, {q, 1}};
  const std::string two = "the operating point gives q two values";
  EXPECT_THAT(model.linearize(doubled).failures(), testing::Contains(two));
  EXPECT_THAT(model.linearize({{u, 0}}, {{q, 1}, {"q", 1}}).failures(), testing::Contains(two));
  EXPECT_THAT(
      model.linearize({{q, x + 1}}).failures(),
      ElementsAre("the value of q at the operating point contains x, which the system does not have"));
}

// A prescribed angle is an input together with both of its derivatives.
TEST(linearization, takes_prescribed_quantities_and_their_derivatives_as_inputs) {
  using namespace rotating_tube;
  auto model = kanexpr::derive<System>();
  auto linear = model.linearize();
  EXPECT_THAT(linear.inputs(), ElementsAre("theta", "theta'", "theta''"));
  EXPECT_EQ(linear.explicit_form().B.columns, 3);
  EXPECT_EQ(print(linear.explicit_form().B(1, 1)), "2*q*theta'");
}

// All values, half of the values or no values as numbers give the same result.
TEST(linearization, agrees_with_itself_however_much_is_given) {
  using namespace double_pendulum;
  auto model = kanexpr::derive<System>();
  const auto& m = model.mechanism();
  linearization_point states, parameters;
  Eigen::VectorXd x(4), p(m.parameters.size()), r(2);
  x << 0.3, -1.1, 0.7, 0.4;
  r << 0.6, -0.2;
  for (int i = 0; i < 2; ++i) {
    states.set(print(m.coordinates[i]), x(i)).set(print(m.speeds[i]), x(2 + i));
    states.set(print(m.inputs[i]), r(i));
  }
  for (int i = 0; i < p.size(); ++i) parameters.set(print(m.parameters[i]), p(i) = 0.5 + 0.1 * i);
  const auto value = [&](kanexpr::runtime::linearization linear) {
    EXPECT_THAT(linear.failures(), IsEmpty());
    return Eigen::MatrixXd(model.function(linear.explicit_form().A)(0.0, x, p, r));
  };
  const Eigen::MatrixXd none = value(model.linearize());
  EXPECT_LE((value(model.linearize(states)) - none).norm(), 1e-13 * none.norm());
  EXPECT_LE((value(model.linearize(parameters)) - none).norm(), 1e-13 * none.norm());
  EXPECT_LE((value(model.linearize(states, parameters)) - none).norm(), 1e-13 * none.norm());
}

TEST(linearization, gives_outputs) {
  using namespace simple_pendulum;
  auto model = kanexpr::derive<System>();
  auto linear = model.linearize({{q, 0}, {u, 0}, {c, 0}, {"T", 0}});
  const auto seen = linear.outputs(model.measured_by<q, dot(acceleration_of<P>, A::y)>());
  EXPECT_EQ(print(seen.C), "[1,  0]\n"
                           "[-g, 0]");
  EXPECT_EQ(print(seen.D), "[0      ]\n"
                           "[1/(l*m)]");
}

// The model may no longer exist.
TEST(linearization, keeps_what_it_needs) {
  using namespace simple_pendulum;
  auto linear = kanexpr::derive<System>().linearize({{q, 0}, {c, 0}});
  EXPECT_EQ(print(linear.explicit_form().A), "[0,    1]\n"
                                             "[-g/l, 0]");
}

namespace mistaken {
using namespace simple_pendulum;
struct System : kanexpr::kane_system<kanexpr::inertial<N>, kanexpr::coordinates<q>, kanexpr::speeds<u>,
                                     kanexpr::kinematics<dot(q) == 2 * q>, kanexpr::bodies<Bob>> {};
} // namespace mistaken

TEST(linearization, tells_the_mistake_of_a_system) {
  auto linear = kanexpr::derive<mistaken::System>().linearize();
  EXPECT_THAT(linear.failures(), ElementsAre("speed u appears in no kinematic differential equation"));
  EXPECT_EQ(linear.explicit_form().A.rows, 0);
  EXPECT_THAT(linear.states(), IsEmpty());
}

// A pendulum of length zero moves no mass, whatever its mass.
TEST(linearization, says_that_the_rates_cannot_be_solved_for) {
  using namespace simple_pendulum;
  auto model = kanexpr::derive<System>();
  auto symbolic = model.linearize({{q, 0}, {u, 0}, {l, 0}});
  symbolic.explicit_form();
  EXPECT_FALSE(symbolic);
  auto numbers = model.linearize({{q, 0}, {u, 0}, {l, 0}}, {{m, 1}, {g, 10}, {c, 0}, {"T", 0}});
  numbers.explicit_form();
  EXPECT_FALSE(numbers);
}

TEST(linearization, tells_the_permutation) {
  using namespace pendulum_nonminimal; // q2, q1 with q1 dependent; u2, u1 with u1 dependent
  auto model = kanexpr::derive<System>();
  EXPECT_EQ(print(model.linearize().permutation()), "[1, 0, 0, 0]\n"
                                                    "[0, 0, 1, 0]\n"
                                                    "[0, 1, 0, 0]\n"
                                                    "[0, 0, 0, 1]");
}

} // namespace
