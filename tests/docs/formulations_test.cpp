// builds: clang++
// The forms of the equations of a system: docs/guide/formulations.md.
#include "docs/printed.hpp"
#include "docs/text.hpp"
#include "models/arm3.hpp"
#include "models/chaplygin_sleigh.hpp"
#include "models/double_pendulum.hpp"
#include "models/four_bar.hpp"
#include "models/pendulum6.hpp"

#include <kanexpr/derivation/cost.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/explain.hpp>

#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <set>

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

#include <docs/guide/formulations/convert.cpp>

TEST(formulations, take_the_values_of_the_original_system) {
  using eom = equations_of_motion<System>;
  eom::state x;
  eom::parameters p;
  x << 0.3, -0.5, 0.9, 0.2, -0.1, 0.4;
  for (Eigen::Index i = 0; i < p.size(); ++i) p[i] = 1 + 0.125 * static_cast<double>(i);
  const eom::inputs r(0.7);
  const Eigen::Vector3d expected = eom::udot(x, p, r);
  EXPECT_GT(expected.norm(), 0.1);
  EXPECT_LE((udot_of(x, p, r) - expected).norm(), 1e-12 * expected.norm());
}

#include <docs/guide/formulations/weights.cpp>

TEST(formulations, are_compared_by_weights) {
  EXPECT_LT(on_a_server.best().weighted, explain<System>().best().weighted);
  const symbolic::cost c = on_a_board.chosen().cost;
  EXPECT_EQ(on_a_board.chosen().weighted, 10 * c.multiplications + 12 * c.additions + 45 * c.divisions +
                                              400 * c.trigonometric + 60 * c.square_roots +
                                              500 * (c.other - c.square_roots));
  EXPECT_EQ(equations_of_motion<OnBoard>::cost(equations_of_motion<OnBoard>::udot), c);
  EXPECT_NE(on_a_board.text().find("\n\nweights: multiplication 10, addition 12, fused 22, division 45, "
                                   "square_root 60, trigonometric 400, other 500\n"),
            std::string::npos)
      << on_a_board.text();
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

// A chain whose first links rotate about parallel axes, if all of them do: a planar one. Its speeds are those
// of the angles, or of a planar chain the angular velocities in the ground.
struct chain : builder {
  chain(int links, bool is_planar, bool from_ground = false) : builder("N") {
    frame_id frame = inertial_frame();
    point_id hinge = origin("O");
    expression below = number(0.0); // the angular velocity of the link below
    for (int i = 1; i <= links; ++i) {
      const std::string k = std::to_string(i);
      const expression q = coordinate("q" + k), u = speed("u" + k);
      const double sign = i == 3 ? -1 : 1;
      kinematic_equation(dot(q) - (from_ground ? sign * (u - below) : u));
      below = u;
      const bool about_x = !is_planar && i % 2 == 0;
      frame = rotated("A" + k, frame, q, along(frame, about_x ? 1 : 0, 0, about_x ? 0 : sign));
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

// Particles that slide along the lines y = 2 x.
struct particles : builder {
  explicit particles(int count) : builder("N") {
    const point_id at = origin("O");
    for (int i = 1; i <= count; ++i) {
      const std::string k = std::to_string(i);
      const expression x = coordinate("x" + k), y = coordinate("y" + k), u = speed("u" + k),
                       w = speed("w" + k);
      kinematic_equation(dot(x) - u);
      kinematic_equation(dot(y) - w);
      particle("B" + k, offset("P" + k, at, along(inertial_frame(), x, y, 0)), number(1));
      velocity_constraint(w - 2 * u);
    }
    gravity(along(inertial_frame(), 0, -9.81, 0));
  }
};

TEST(formulations, name_all_choices_of_dependent_speeds) {
  const particles two(2);
  std::set<std::string> found;
  for (const formulation_candidate& each : explain(two).candidates)
    if (each.word.starts_with("dependent<")) found.insert(each.word);
  found.insert("dependent<u1, u2>"); // chosen by the library
  EXPECT_EQ(found, (std::set<std::string>{"dependent<u1, u2>", "dependent<u1, w2>", "dependent<w1, u2>",
                                          "dependent<w1, w2>"}));
}

// 40 speeds have 137 846 528 820 choices of 20.
TEST(formulations, do_not_try_too_many_choices_of_dependent_speeds) {
  const particles many(20), two(2);
  const explanation forms = explain(many), unsearched = explain(two, {.searches = false});
  const formulation_candidate& others = called(forms, "other dependent speeds");
  EXPECT_EQ(others.cause, "there are more than 400 choices");
  EXPECT_TRUE(others.is_left_out);
  EXPECT_EQ(called(unsearched, "other dependent speeds").cause, "the options omit searches");
  EXPECT_EQ(called(explain<chaplygin_sleigh::System>(), "other dependent speeds").cause,
            "the constraints can be solved for no others");
}

TEST(formulations, name_the_solution) {
  const explain_options briefly{.searches = false};
  const auto solution_of = [&](const builder& b) {
    const explanation forms = explain(b, briefly);
    const formulation_candidate &by_elimination = called(forms, "by elimination"),
                                &by_bodies = called(forms, "by articulated bodies");
    const bool is_by_bodies = forms.solved_by == mechanics::solution::articulated_bodies;
    EXPECT_NE(by_elimination.cost, by_bodies.cost);
    if (b.mechanism().formulated.speeds == mechanics::internal_speeds::given)
      EXPECT_EQ(forms.chosen().cost, (is_by_bodies ? by_bodies : by_elimination).cost);
    return forms.text().substr(0, forms.text().find(')')).substr(forms.text().find('(') + 1);
  };
  chain small(5, true), middle(9, true), large(16, true);
  EXPECT_EQ(solution_of(small), "elimination");
  EXPECT_EQ(solution_of(middle), "articulated bodies"); // after M is formed
  EXPECT_EQ(solution_of(large), "articulated bodies");  // without M
  large.in_absolute_speeds();
  EXPECT_EQ(solution_of(large), "elimination");
  large.by_articulated_bodies();
  EXPECT_EQ(solution_of(large), "articulated bodies");
  const explanation of_mass = explain(large, {.results = {mechanics::quantity::mass_matrix}});
  EXPECT_EQ(of_mass.solved_by, mechanics::solution::cheapest);
  EXPECT_EQ(of_mass.text().find('('), std::string::npos);
}

TEST(formulations, are_empty_after_a_mistake) {
  for (const explanation& none : {explain(builder("N")), explain(chain(2, true), {.results = {}})}) {
    EXPECT_NE(none.mistake, "");
    for (const formulation_candidate* each : {&none.chosen(), &none.best()}) {
      EXPECT_FALSE(each->applies());
      EXPECT_EQ(each->cause, "the system has no forms");
      EXPECT_EQ(each->word, "");
      EXPECT_TRUE(each->form.frames.empty());
    }
  }
}

TEST(formulations, name_the_reason_why_one_does_not_apply) {
  chain spatial(3, false);
  sliding_chain with_loop;
  const explain_options briefly{.searches = false};
  EXPECT_EQ(
      called(explain(spatial, briefly), "absolute speeds").cause,
      "no two bodies, one on the other, rotate about parallel axes of the ground, each at a speed of its "
      "own");
  constexpr const char* from_ground =
      "bodies that rotate about parallel axes of the ground have absolute speeds already";
  EXPECT_EQ(called(explain<double_pendulum::System>(briefly), "absolute speeds").cause, from_ground);
  EXPECT_EQ(called(explain(chain(3, true, true), briefly), "absolute speeds").cause, from_ground);
  EXPECT_TRUE(called(explain(chain(3, true), briefly), "absolute speeds, by elimination").applies());
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
  for (int links = 8; links <= 12; ++links) {
    chain in_plane(links, true);
    in_plane.weighted_by({.fused = 1});
    const explanation forms = explain(in_plane, fusing);
    for (const formulation_candidate& each : forms.candidates)
      if (each.called == "by elimination" || each.called == "by articulated bodies")
        EXPECT_LE(forms.chosen().weighted, each.weighted) << links << " links " << each.called;
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
