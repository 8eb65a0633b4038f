// builds: g++
// Bodies from headers that the command kanexpr-flexible-body has written, compared with run-time models.
#include <kanexpr/flexible.hpp>
#include <kanexpr/flexible/header_writer.hpp>
#include <kanexpr/flexible/read_modes.hpp>
#include <kanexpr/flexible/read_sid.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/model.hpp>

#include <boom.hpp>
#include <cantilever.hpp>
#include <panel.hpp>

#include <Eigen/Core>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr coordinate<"bend1"> bend1;
constexpr coordinate<"bend2"> bend2;
constexpr speed<"rate1"> rate1;
constexpr speed<"rate2"> rate2;
constexpr parameter<"g"> g;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct Panel : flexible_body<Panel, O, A, panel::data> {};
struct Corner : node<Corner, Panel, 12> {};
struct Rod : flexible_body<Rod, Corner, Corner, cantilever::data, by<bend1, bend2, rate1, rate2>> {};
struct Tip : node<Tip, Rod, "tip"> {};
struct Bob : rigid_body<Bob, Tip, Tip, 0.5, inertia<Tip, 0.1, 0.2, 0.25>> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            bodies<Panel, Rod, Bob>, loads<gravity<-g * N::y>>> {};

mechanics::flexible_data data_in(const std::string& file) {
  const flexible::read_body read = flexible::read_sid(std::string(KANEXPR_FLEXIBLE_FILES) + "/" + file);
  EXPECT_TRUE(read) << read.cause();
  return read.data;
}

/// The same system at run time.
struct built : runtime::builder {
  built() : builder("N") {
    const auto angle = coordinate("q"), first = coordinate("q1_Panel"), second = coordinate("q2_Panel"),
               third = coordinate("bend1"), fourth = coordinate("bend2");
    const auto rate = speed("u"), rate_1 = speed("u1_Panel"), rate_2 = speed("u2_Panel"),
               rate_3 = speed("rate1"), rate_4 = speed("rate2");
    kinematic_equation(dot(angle) - rate);
    kinematic_equation(dot(first) - rate_1), kinematic_equation(dot(second) - rate_2);
    kinematic_equation(dot(third) - rate_3), kinematic_equation(dot(fourth) - rate_4);
    const auto n = inertial_frame(), a = rotated("A", n, angle, along(n, 0, 0, 1));
    const auto panel_body = flexible_body("Panel", origin("O"), a, {first, second}, data_in("panel.SID_FEM"));
    const auto corner = node("Corner", panel_body, "12");
    const auto rod =
        flexible_body("Rod", corner.point, corner.frame, {third, fourth}, data_in("cantilever.SID_FEM"));
    const auto tip = node("Tip", rod, "tip");
    rigid_body("Bob", tip.point, tip.frame, number(0.5), inertia(tip.frame, 0.1, 0.2, 0.25));
    gravity(along(n, 0, -parameter("g"), 0));
  }
};

TEST(flexible_compiled, equals_the_run_time_model) {
  built b;
  ASSERT_EQ(b.check().view(), "");
  model at_run_time = derive(b);
  using eom = equations_of_motion<System>;
  const eom::state x{{q, 0.3},
                     {coordinate<"q1_Panel">{}, 0.02},
                     {coordinate<"q2_Panel">{}, -0.05},
                     {bend1, 0.04},
                     {bend2, 0.01},
                     {u, 1.3},
                     {speed<"u1_Panel">{}, 0.7},
                     {speed<"u2_Panel">{}, -0.4},
                     {rate1, 0.2},
                     {rate2, -0.9}};
  const eom::parameters p{{g, 9.81}};
  const Eigen::VectorXd found = eom::rhs(x, p, {});
  const Eigen::VectorXd expected = at_run_time.function(at_run_time.rhs())(x, p);
  ASSERT_EQ(found.size(), 10);
  EXPECT_EQ(found, expected);
  model of_types = derive<System>();
  EXPECT_EQ(of_types.function(of_types.rhs())(x, p), expected);
}

struct Lagrange_system
    : lagrange_system<inertial<N>, coordinates<q>, bodies<Panel, Rod, Bob>, loads<gravity<-g * N::y>>> {};

TEST(flexible_compiled, agrees_with_lagranges_method) {
  model by_kane = derive<System>(), by_lagrange = derive<Lagrange_system>();
  ASSERT_EQ(by_lagrange.mistake(), "");
  Eigen::VectorXd x(10);
  x << 0.3, 0.02, -0.05, 0.04, 0.01, 1.3, 0.7, -0.4, 0.2, -0.9;
  const Eigen::VectorXd p = Eigen::VectorXd::Constant(1, 9.81);
  const Eigen::VectorXd found = by_lagrange.function(by_lagrange.rhs())(x, p),
                        expected = by_kane.function(by_kane.rhs())(x, p);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_LE((found - expected).norm(), 1e-12 * expected.norm());
}

bool are_equal(const base::sequence<double>& a, const base::sequence<double>& b) {
  if (a.size() != b.size()) return false;
  for (int i = 0; i < a.size(); ++i)
    if (!base::equal(a[i], b[i])) return false;
  return true;
}

TEST(flexible_compiled, headers_contain_the_numbers_of_the_files) {
  const auto expect_same = [](const mechanics::flexible_data& a, const mechanics::flexible_data& b) {
    EXPECT_EQ(a.mass, b.mass);
    EXPECT_TRUE(are_equal(a.first_moment.coefficients, b.first_moment.coefficients));
    EXPECT_TRUE(are_equal(a.inertia.coefficients, b.inertia.coefficients));
    EXPECT_TRUE(are_equal(a.angular.coefficients, b.angular.coefficients));
    EXPECT_TRUE(are_equal(a.modal_mass, b.modal_mass));
    EXPECT_TRUE(are_equal(a.stiffness, b.stiffness));
    EXPECT_TRUE(are_equal(a.damping, b.damping));
    EXPECT_TRUE(are_equal(a.preload, b.preload));
    ASSERT_EQ(a.elastic_terms.size(), b.elastic_terms.size());
    for (int i = 0; i < a.elastic_terms.size(); ++i) {
      EXPECT_EQ(a.elastic_terms[i].coefficient, b.elastic_terms[i].coefficient);
      EXPECT_THAT(a.elastic_terms[i].amplitudes, testing::ElementsAreArray(b.elastic_terms[i].amplitudes));
    }
    ASSERT_EQ(a.damping_terms.size(), b.damping_terms.size());
    for (int i = 0; i < a.damping_terms.size(); ++i) {
      EXPECT_EQ(a.damping_terms[i].coefficient, b.damping_terms[i].coefficient);
      EXPECT_EQ(a.damping_terms[i].row, b.damping_terms[i].row);
      EXPECT_EQ(a.damping_terms[i].column, b.damping_terms[i].column);
      EXPECT_THAT(a.damping_terms[i].amplitudes, testing::ElementsAreArray(b.damping_terms[i].amplitudes));
    }
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (int i = 0; i < a.nodes.size(); ++i) {
      EXPECT_EQ(a.nodes[i].called.view(), b.nodes[i].called.view());
      EXPECT_TRUE(are_equal(a.nodes[i].position.coefficients, b.nodes[i].position.coefficients));
      EXPECT_TRUE(are_equal(a.nodes[i].orientation, b.nodes[i].orientation));
      EXPECT_TRUE(are_equal(a.nodes[i].rotation, b.nodes[i].rotation));
      EXPECT_TRUE(are_equal(a.nodes[i].second_rotation, b.nodes[i].second_rotation));
    }
  };
  expect_same(panel::data.values(), data_in("panel.SID_FEM"));
  EXPECT_EQ(panel::data.values().elastic_terms.size(), 9); // four of third order, five of fourth
  EXPECT_EQ(panel::data.values().nodes[0].second_rotation.size(), 12);
  expect_same(cantilever::data.values(), data_in("cantilever.SID_FEM"));
  const flexible::read_body read = flexible::read_modes(std::string(KANEXPR_FLEXIBLE_FILES) + "/boom.json");
  ASSERT_TRUE(read) << read.cause();
  expect_same(boom::data.values(), read.data);
}

TEST(flexible_compiled, a_header_may_describe_any_name) {
  mechanics::flexible_data d(1);
  d.nodes.push({.called = "a\"b\\c\n", .position = mechanics::taylor_series(3, 1)});
  const std::string text = flexible::header_writer(d).write("odd", "x\n#error");
  EXPECT_NE(text.find("from x_#error."), text.npos) << text;
  EXPECT_EQ(text.find("\\c"), text.npos) << text;
}

} // namespace
