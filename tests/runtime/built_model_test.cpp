// builds: clang++
// Models from a builder, compared with models of the same systems described by types.
#include "no_heap.hpp"
#include "runtime/agreement.hpp"
#include "runtime/built_pendulum.hpp"

#include <kanexpr/runtime/builder.hpp>

#include <models/simple_pendulum.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <type_traits>

namespace {

using kanexpr::derive;
using kanexpr::model;
using kanexpr::runtime::builder;
using kanexpr::symbolic::expression;
using kanexpr::symbolic::print;

static_assert(std::is_copy_constructible_v<model> && std::is_copy_assignable_v<model>);
static_assert(std::is_nothrow_move_constructible_v<model> && std::is_nothrow_move_assignable_v<model>);

struct pendulum : built_pendulum {
  pendulum() { torque(rod, along(n, 0, 0, motor)); }
};

model model_of_pendulum() { return derive(pendulum()); } // the builder does not outlive this

TEST(built_model, is_printed_and_evaluated_like_one_of_words) {
  model built = model_of_pendulum();
  ASSERT_EQ(built.mistake(), "");
  EXPECT_EQ(print(built.mass_matrix()), "[l^2*m]");
  EXPECT_EQ(print(built.forcing()), "[T - g*l*m*sin(q)]");
  EXPECT_EQ(latex(built.mass_matrix()), "\\begin{bmatrix}\nl^{2} m\n\\end{bmatrix}");
  auto udot = built.function(built.udot());
  const Eigen::Vector2d x(0.5, -1.2);
  const Eigen::Vector3d p(1.5, 2, 9.81);
  EXPECT_NEAR(udot(x, p, Eigen::Matrix<double, 1, 1>(0.6))(0), 0.6 / (1.5 * 4) - 9.81 / 2 * std::sin(0.5),
              1e-15);
  EXPECT_TRUE(udot.status());
}

TEST(built_model, does_not_read_past_the_end_of_a_vector) {
  model built = model_of_pendulum();
  auto udot = built.function(built.udot());
  const Eigen::Vector2d x(0.5, -1.2);
  const Eigen::Vector3d p(1.5, 2, 9.81);
  const Eigen::Matrix<double, 1, 1> r(0.6);
  const no_heap::guard guard;
  EXPECT_TRUE(std::isnan(udot(x, p.head<2>(), r)(0)));
  EXPECT_EQ(udot.status().view(), "the parameter vector has 2 entries, but none for g");
  EXPECT_TRUE(std::isnan(udot(x, p, r.head(0))(0)));
  EXPECT_EQ(udot.status().view(), "the input vector has 0 entries, but none for T");
  EXPECT_TRUE(std::isnan(udot(x.head(0), p, r)(0)));
  EXPECT_EQ(udot.status().view(), "the state vector has 0 entries, but none for q");
  EXPECT_TRUE(std::isfinite(udot(x, p, r)(0)));
  EXPECT_TRUE(udot.status());
}

TEST(built_model, needs_the_rates_that_a_result_holds) {
  model built = model_of_pendulum();
  auto forces = built.function(built.inertia_forces());
  const Eigen::Vector2d x(0.5, -1.2);
  const Eigen::Vector3d p(1.5, 2, 9.81);
  const Eigen::Matrix<double, 1, 1> r(0.6), a(2);
  EXPECT_TRUE(std::isnan(forces(0, x, p, r, a.head(0))(0)));
  EXPECT_EQ(forces.status().cause(), "the acceleration vector has 0 entries, but none for u");
  EXPECT_NEAR(forces(0, x, p, r, a)(0), -1.5 * 4 * 2, 1e-13);
}

TEST(built_model, is_linearized_with_symbols_by_their_names) {
  model built = model_of_pendulum();
  constexpr kanexpr::coordinate<"q"> q;
  constexpr kanexpr::parameter<"l"> l;
  kanexpr::runtime::linearization linear = built.linearize({{q, 0}, {"u", 0}, {"T", 0}, {"g", 2 * l}});
  EXPECT_TRUE(linear);
  EXPECT_EQ(print(linear.explicit_form().A), "[0,  1]\n[-2, 0]");
  EXPECT_EQ(print(linear.explicit_form().B), "[0        ]\n[1/(l^2*m)]");
  EXPECT_THAT(linear.states(), testing::ElementsAre("q", "u"));
  EXPECT_THAT(built.linearize({{"w", 0}}).failures(),
              testing::ElementsAre("the operating point refers to w, which the system does not have"));
  EXPECT_THAT(built.linearize({{"q", 1}, {"u", 0}, {"T", 0}, {"u'", 0}}).failures(),
              testing::ElementsAre("the operating point does not satisfy dynamic differential equation 1: "
                                   "the residual is 0.8414709848078965*g*l*m"));
}

TEST(built_model, does_not_change_with_what_is_built_afterwards) {
  pendulum b;
  model before = derive(b);
  b.torsional_spring(b.q, b.parameter("k"));
  model after = derive(b);
  EXPECT_EQ(print(before.forcing()), "[T - g*l*m*sin(q)]");
  EXPECT_EQ(print(after.forcing()), "[T - g*l*m*sin(q) - k*q]");
}

TEST(built_model, has_the_mistake_of_the_builder) {
  pendulum b;
  b.speed("q");
  model built = derive(b);
  EXPECT_EQ(built.mistake(), "the name q is used twice");
  EXPECT_EQ(built.udot().rows, 0);
  EXPECT_THAT(built.linearize().failures(), testing::ElementsAre("the name q is used twice"));
}

TEST(built_model, has_the_mistake_of_the_mechanism) {
  pendulum b;
  b.coordinate("q2");
  EXPECT_NE(derive(b).mistake(), "");
  EXPECT_EQ(derive(b).mistake(), std::string(b.check().view()));
}

TEST(model, is_shared_by_its_copies) {
  model first = derive<simple_pendulum::System>();
  model second = first;
  EXPECT_EQ(second.mass_matrix().entries[0], first.mass_matrix().entries[0]);
  EXPECT_TRUE(second.mass_matrix().entries[0].belongs_to(first.graph()));
  const model moved = std::move(first);
  EXPECT_EQ(&moved.mechanism(), &second.mechanism());
  first = model_of_pendulum();
  EXPECT_EQ(print(first.mass_matrix()), "[l^2*m]");
}

// Carts on one rail; the first pulls all others.
struct train : builder {
  static constexpr int carts = 60;

  train() : builder("N") {
    const auto n = inertial_frame();
    const auto o = origin("O");
    const expression lead = coordinate("lead"), u = speed("v"), l = parameter("l");
    kinematic_equation(dot(lead) - u);
    particle("Lead", offset("Front", o, along(n, lead, number(0.0), number(0.0))), number(2));
    for (int i = 0; i < carts; ++i) {
      const std::string cart = std::to_string(i + 1);
      const expression q = coordinate("cart" + cart), v = speed("speed" + cart);
      kinematic_equation(dot(q) - v);
      particle("Cart" + cart, offset("P" + cart, o, along(n, q, number(0.0), number(0.0))), number(1));
      velocity_constraint(v * l - u);
      dependent(v);
    }
  }
};

TEST(built_model, names_all_dependent_speeds_however_many) {
  std::string all;
  for (int i = 1; i <= train::carts; ++i)
    all += (i == 1 ? "speed" : i < train::carts ? ", speed" : " and speed") + std::to_string(i);
  EXPECT_GT(all.size(), 500u);
  EXPECT_EQ(derive(train()).names_of_dependent_speeds(), all);
}

TEST(built_model, names_ten_in_a_sentence_about_many) {
  const train built;
  kanexpr::base::sequence<int> places;
  for (int i = 1; i <= 12; ++i) places.push(i);
  const std::string ten =
      "speeds speed1, speed2, speed3, speed4, speed5, speed6, speed7, speed8, speed9, speed10";
  EXPECT_EQ(kanexpr::mechanics::speeds_called(built.mechanism(), places).view(), ten + " and 2 others");
  places.pop();
  EXPECT_EQ(kanexpr::mechanics::speeds_called(built.mechanism(), places).view(), ten + " and speed11");
}

} // namespace
