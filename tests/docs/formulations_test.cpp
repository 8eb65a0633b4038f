// builds: clang++
// The forms of the equations of a system: docs/guide/formulations.md.
#include "docs/printed.hpp"
#include "docs/text.hpp"
#include "models/arm3.hpp"
#include "models/four_bar.hpp"
#include "models/pendulum6.hpp"

#include <kanexpr/derivation/cost.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/explain.hpp>

#include <gtest/gtest.h>

#include <iostream>
#include <random>

namespace {

using namespace kanexpr;

namespace linkage {

using namespace four_bar;

TEST(formulations, are_printed) {
  const docs::printed here;
#include <docs/guide/formulations/explain.cpp>
  EXPECT_EQ(here.text(), docs::text("docs/guide/formulations/explained.text"));
}

#include <docs/guide/formulations/state.cpp>

TEST(formulations, are_counted_like_the_compiled_code) {
  using eom = equations_of_motion<System>;
  using cheaper = equations_of_motion<Cheaper>;
  const explanation forms = explain<System>();
  EXPECT_EQ(forms.mistake, "");
  EXPECT_EQ(forms.chosen().cost, eom::cost(eom::udot));
  EXPECT_EQ(forms.best().cost, cheaper::cost(cheaper::udot));
  const explanation again = explain<Cheaper>();
  EXPECT_EQ(again.chosen().called, "as the model states");
  EXPECT_EQ(again.chosen().cost, cheaper::cost(cheaper::udot));
}

#include <docs/guide/formulations/weights.cpp>

TEST(formulations, are_compared_by_weights) {
  EXPECT_LT(on_a_server.best().weighted, explain<System>().best().weighted);
  const symbolic::cost c = on_a_board.chosen().cost;
  EXPECT_EQ(on_a_board.chosen().weighted, 10 * c.multiplications + 12 * c.additions + 45 * c.divisions +
                                              400 * c.trigonometric + 60 * c.square_roots +
                                              500 * (c.other - c.square_roots));
  EXPECT_EQ(equations_of_motion<OnBoard>::cost(equations_of_motion<OnBoard>::udot), c);
}

TEST(formulations, count_a_fused_product_as_a_product_and_a_sum) {
  constexpr operation_weights derived{.multiplication = 10, .addition = 12},
      stated{.addition = 3, .fused = 2};
  static_assert(derived.fused == 22 && operation_weights{}.fused == 2);
  EXPECT_EQ(runtime::word_of(derived),
            "weighted_by<operation_weights{.multiplication = 10, .addition = 12}>");
  EXPECT_EQ(runtime::word_of(stated), "weighted_by<operation_weights{.addition = 3, .fused = 2}>");
}

TEST(formulations, are_listed) {
  const docs::printed here;
#include <docs/guide/formulations/options.cpp>
  EXPECT_TRUE(here.text().starts_with("chosen by the library: ")) << here.text();
}

#include <docs/guide/formulations/others.cpp>

template <class System>
int operations() {
  const symbolic::cost c = derivation::cost_of<System>({mechanics::quantity::udot});
  return c.multiplications + c.additions;
}

TEST(formulations, take_the_operations_on_the_page) {
  EXPECT_EQ(operations<pendulum6::System>(), 314);
  EXPECT_EQ(operations<Chain>(), 261);
  EXPECT_EQ(operations<arm3::System>(), 360);
  EXPECT_EQ(operations<Arm>(), 334);
}

} // namespace linkage

using runtime::builder;
using runtime::frame_id;
using runtime::point_id;
using symbolic::expression;

// A chain whose first links rotate about parallel axes, if all of them do: a planar one.
struct chain : builder {
  chain(int links, bool is_planar) : builder("N") {
    frame_id frame = inertial_frame();
    point_id hinge = origin("O");
    for (int i = 1; i <= links; ++i) {
      const std::string k = std::to_string(i);
      const expression q = coordinate("q" + k), u = speed("u" + k);
      kinematic_equation(dot(q) - u);
      const bool about_x = !is_planar && i % 2 == 0;
      frame = rotated("A" + k, frame, q, along(frame, about_x ? 1 : 0, 0, about_x ? 0 : i == 3 ? -1 : 1));
      rigid_body("B" + k, offset("C" + k, hinge, along(frame, 0.1 * i, -0.4, 0.05)), frame,
                 number(1 + 0.1 * i), inertia(frame, number(0.2), number(0.15), number(0.1 + 0.01 * i)));
      torque(frame, along(frame, 0, 0, input("T" + k)));
      hinge = offset("P" + k, hinge, along(frame, 0.05, -0.9, 0));
    }
    torsional_spring(m_angle(), number(3), number(0.1));
    gravity(along(inertial_frame(), 0, -9.81, 0));
  }

private:
  expression m_angle() { return mechanism().coordinates[1]; }
};

// A chain with a loop: its tip slides along a line.
struct sliding_chain : chain {
  sliding_chain() : chain(3, true) {
    const mechanics::known_motion known(mechanism());
    const point_id tip{static_cast<int>(mechanism().points.size()) - 1};
    configuration_constraint(zero_along(position_of(tip, point_id{0}), along(inertial_frame(), 1, 0, 0)));
  }
};

Eigen::VectorXd udot_of(const builder& b) {
  auto m = derive(b);
  EXPECT_EQ(m.mistake(), "");
  auto f = m.function(m.udot());
  std::mt19937 dice(5);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto drawn = [&](Eigen::Index n) {
    return Eigen::VectorXd::NullaryExpr(n, [&] { return any(dice); });
  };
  const Eigen::VectorXd x = drawn(2 * m.mechanism().speeds.size()), r = drawn(m.mechanism().inputs.size());
  const Eigen::VectorXd found = f(0, x, Eigen::VectorXd(), r);
  EXPECT_TRUE(found.allFinite());
  return found;
}

void expect_same_motion_in_all_forms(builder& b) {
  const explanation forms = explain(b);
  ASSERT_EQ(forms.mistake, "");
  const Eigen::VectorXd expected = udot_of(b);
  int forms_with_a_change = 0;
  for (const formulation_candidate& each : forms.candidates) {
    if (!each.applies() || each.word.starts_with("dependent")) continue;
    b.formulation(each.form);
    const Eigen::VectorXd found = udot_of(b);
    EXPECT_LE((found - expected).norm(), 1e-12 * expected.norm()) << each.called;
    if (found != expected) ++forms_with_a_change;
  }
  EXPECT_GE(forms_with_a_change, 3);
}

TEST(formulations, give_the_same_motion) {
  chain planar(4, true), spatial(4, false);
  sliding_chain with_loop;
  expect_same_motion_in_all_forms(planar);
  expect_same_motion_in_all_forms(spatial);
  expect_same_motion_in_all_forms(with_loop);
}

const formulation_candidate& called(const explanation& forms, std::string_view name) {
  for (const formulation_candidate& c : forms.candidates)
    if (c.called == name) return c;
  ADD_FAILURE() << "no candidate is called " << name;
  return forms.chosen();
}

TEST(formulations, are_cheaper_for_a_planar_chain) {
  chain b(6, true);
#include <docs/guide/formulations/builder.cpp>
  EXPECT_EQ(cheapest.mistake(), "");
  EXPECT_LT(forms.best().weighted, 0.95 * static_cast<double>(forms.chosen().weighted));
  EXPECT_LT(called(forms, "absolute speeds, by elimination").weighted,
            called(forms, "by elimination").weighted);
  EXPECT_EQ(explain(b, {.searches = false}).chosen().cost, forms.best().cost);
  EXPECT_EQ(explain(b, {.searches = false}).chosen().called, "as the model states");
}

TEST(formulations, name_the_reason_why_one_does_not_apply) {
  chain spatial(3, false);
  sliding_chain with_loop;
  const explain_options briefly{.searches = false};
  EXPECT_EQ(called(explain(spatial, briefly), "absolute speeds").cause,
            "no two bodies, one on the other, rotate about parallel axes of the ground");
  EXPECT_EQ(called(explain(spatial, briefly), "other dependent speeds").cause, "it has no constraints");
  EXPECT_EQ(called(explain(with_loop, briefly), "by articulated bodies").cause, "it has constraints");
  EXPECT_EQ(called(explain<four_bar::LagrangeSystem>(briefly), "by articulated bodies").cause,
            "its equations are derived by Lagrange's method");

  const explain_options of_derivatives{.results = {mechanics::quantity::state_matrix}, .searches = false};
  chain plain(3, true), solved_otherwise(3, true);
  solved_otherwise.by_articulated_bodies();
  solved_otherwise.in_absolute_speeds();
  const explanation forms = explain(plain, of_derivatives);
  EXPECT_EQ(forms.chosen().cost, explain(solved_otherwise, of_derivatives).chosen().cost);
  for (const char* const each : {"by articulated bodies", "absolute speeds"})
    EXPECT_EQ(called(forms, each).cause, "only udot and rhs depend on it");

  builder without_motion("N");
  EXPECT_EQ(explain(without_motion).mistake, "the system has no generalized speeds");
  EXPECT_EQ(explain(without_motion).text(), "the system has no generalized speeds\n");
  EXPECT_EQ(explain(plain, {.results = {}}).mistake, "the options of explain list no result");
  EXPECT_EQ(explain(plain, {.results = {mechanics::quantity::multipliers}}).text(),
            "multipliers has no entries\n");
}

TEST(formulations, have_no_negative_weights) {
  const operation_weights negative{.division = -4};
  chain b(2, true);
  EXPECT_EQ(explain(b, {.weights = negative}).mistake,
            "the options of explain give an operation a negative weight");
  b.weighted_by(negative);
  EXPECT_EQ(b.check().cause(), "weighted_by gives an operation a negative weight");
}

// Elimination has more sums that can be evaluated together with a product.
TEST(formulations, depend_on_the_weights) {
  const explain_options plain{.searches = false},
      fusing{.weights = operation_weights{.fused = 1}, .searches = false};
  const chain planar(6, true);
  EXPECT_NE(explain(planar, plain).best().called, explain(planar, fusing).best().called);
  for (int links = 5; links <= 12; ++links) {
    chain with_weights(links, false);
    const long long without = explain(with_weights, fusing).chosen().weighted;
    with_weights.weighted_by({.fused = 1});
    EXPECT_LE(explain(with_weights, fusing).chosen().weighted, without);
  }

  chain b(3, false);
  b.weighted_by({.fused = 1});
  EXPECT_EQ(explain(b, plain).text(), explain(b, fusing).text());
}

TEST(formulations, keep_the_weights_of_the_model) {
  const operation_weights weights{.addition = 0, .trigonometric = 30};
  chain b(3, false);
  b.weighted_by(weights);
  const explanation forms = explain(b, {.searches = false});
  for (const formulation_candidate& each : forms.candidates) {
    if (!each.applies()) continue;
    EXPECT_EQ(each.form.weights, weights) << each.called;
    if (!each.word.empty())
      EXPECT_TRUE(each.word.ends_with("weighted_by<operation_weights{.addition = 0, .trigonometric = 30}>>"))
          << each.word;
  }
}

} // namespace
