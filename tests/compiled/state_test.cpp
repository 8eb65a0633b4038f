// builds: clang++ sanitize no-exceptions
#include "no_heap.hpp"

#include <models/double_pendulum.hpp>
#include <models/pendulum6.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace {

using namespace double_pendulum;
using eom = kanexpr::equations_of_motion<System>;

static_assert(eom::coordinates == 2 && eom::speeds == 2);
static_assert(eom::state::SizeAtCompileTime == 4);
static_assert(eom::parameters::SizeAtCompileTime == 10);
static_assert(eom::inputs::SizeAtCompileTime == 2);
static_assert(sizeof(eom::state) == 4 * sizeof(double));
static_assert(kanexpr::equations_of_motion<pendulum6::System>::parameters::SizeAtCompileTime == 0);
static_assert(std::is_same_v<kanexpr::state<System, float>::Scalar, float>);

eom::state some_state() {
  eom::state x;
  x[q1] = 0.1;
  x[q2] = 0.2;
  x[u1] = 0.3;
  x[u2] = 0.4;
  return x;
}

eom::parameters some_parameters() {
  eom::parameters p;
  p << 1.1, 0.6, 0.4, 0.35, 0.9, 0.07, 0.02, 9.81, 0.03, 0.02;
  return p;
}

TEST(state, starts_as_zero) {
  EXPECT_EQ(eom::state(), Eigen::Vector4d::Zero());
  EXPECT_EQ(eom::state().mistake().view(), "");
}

TEST(parameters_and_inputs, are_no_numbers_until_they_are_set) {
  EXPECT_TRUE(eom::parameters().array().isNaN().all());
  EXPECT_TRUE(eom::inputs().array().isNaN().all());
  EXPECT_EQ(eom::parameters().mistake().view(), "parameter m1 has no value");
  eom::inputs r;
  r[T1] = 1;
  EXPECT_EQ(r.mistake().view(), "input T2 has no value");
  EXPECT_FALSE(eom::udot(some_state(), some_parameters(), r).allFinite());
  r[T2] = 0;
  EXPECT_EQ(r.mistake().view(), "");
  EXPECT_TRUE(eom::udot(some_state(), some_parameters(), r).allFinite());
  EXPECT_EQ((kanexpr::input_values<System, float>().mistake().view()), "input T1 has no value");
  EXPECT_EQ((kanexpr::input_values<System, std::complex<double>>().mistake().view()),
            "input T1 has no value");
}

TEST(vectors_by_name, take_every_symbol_once) {
  no_heap::guard guard;
  eom::state x{{u1, 0.3}, {q2, 0.2}, {q1, 0.1}, {u2, 0.4}};
  EXPECT_EQ(x, some_state());
  x = {{q1, 1}, {q2, 2}, {u1, 3}, {u2, 4}};
  EXPECT_EQ(x, Eigen::Vector4d(1, 2, 3, 4));
  eom::inputs r = {{T2, 2}, {"T1", 1.5f}};
  EXPECT_EQ(r, Eigen::Vector2d(1.5, 2));
  EXPECT_EQ(r.mistake().view(), "");
  const kanexpr::input_values<System, std::complex<double>> turned{{T1, 1}, {T2, std::complex<double>(0, 2)}};
  EXPECT_EQ(turned[T2], std::complex<double>(0, 2));
}

TEST(vectors_by_name, tell_what_is_missing_or_wrong) {
  const std::string_view unknown = "T3";
  eom::inputs r{{T1, 1}};
  EXPECT_EQ(r.mistake().view(), "input T2 has no value");
  r = {{T1, 1}, {T2, 2}, {T1, 1}};
  EXPECT_EQ(r.mistake().view(), "input T1 has two values");
  r = {{T1, 1}, {T2, 2}, {unknown, 3}};
  EXPECT_EQ(r.mistake().cause(), "System has no input T3");
  r[T1] = 1;
  EXPECT_EQ(r.mistake().cause(), "System has no input T3");
  for (const auto& [name, told] : {std::pair("weight", "weight"), std::pair("weights", "weigh..."),
                                   std::pair("l\u00e4", "l\u00e4"), std::pair("", "")}) {
    std::ostringstream out;
    out << eom::parameters{{m1, 2}, {name, 3}}.mistake();
    EXPECT_EQ(out.str(), std::string("System has no parameter ") + told);
  }
  EXPECT_EQ((eom::state{{q1, 0.1}, {"q3", 0}}.mistake().cause()), "System has no coordinate or speed q3");
  EXPECT_EQ((kanexpr::input_values<System, float>{{T1, 1}, {unknown, 2}}.mistake().cause()),
            "a name in the list that set the value of input T1 does not belong to System");
  r = {{T1, 1}, {T2, std::nan("")}};
  EXPECT_EQ(r.mistake().view(), "the value of input T2 is not a number");
  EXPECT_EQ(eom::state({{q1, 0.1}, {q2, 0.2}, {u1, 1}}).mistake().view(), "speed u2 has no value");
}

TEST(vectors, are_made_of_all_their_numbers) {
  const eom::state x{0.1, 0.2, 0.3, 0.4};
  EXPECT_EQ(x, some_state());
  const kanexpr::state<System, float> single{1, 2, 3, 4};
  EXPECT_EQ(single, Eigen::Vector4f(1, 2, 3, 4));
  eom::state assigned;
  assigned = {0.1, 0.2, 0.3, 0.4};
  EXPECT_EQ(assigned, some_state());
  assigned = 2 * some_state();
  EXPECT_EQ(assigned, Eigen::Vector4d(0.2, 0.4, 0.6, 0.8));
  eom::parameters p;
  p = {1.1, 0.6, 0.4, 0.35, 0.9, 0.07, 0.02, 9.81, 0.03, 0.02};
  EXPECT_EQ(p, some_parameters());
  const double numbers[]{1, 2};
  EXPECT_EQ(eom::inputs(numbers), Eigen::Vector2d(1, 2));
}

TEST(state, holds_coordinates_and_then_speeds_by_name) {
  const eom::state x = some_state();
  EXPECT_EQ(x, Eigen::Vector4d(0.1, 0.2, 0.3, 0.4));
  EXPECT_EQ(x[u1], 0.3);
  EXPECT_EQ(x.q(), Eigen::Vector2d(0.1, 0.2));
  EXPECT_EQ(x.u(), Eigen::Vector2d(0.3, 0.4));
}

TEST(state, is_an_eigen_vector) {
  eom::state x = some_state();
  x += 2 * some_state();
  x.u() *= 10;
  EXPECT_DOUBLE_EQ(x[u2], 12);
  x = Eigen::Vector4d(1, 2, 3, 4);
  EXPECT_EQ(x[q2], 2);
  EXPECT_EQ(eom::state(Eigen::Vector4d(1, 2, 3, 4)), x);
}

TEST(parameters_and_inputs, are_reached_by_name) {
  const eom::parameters p = some_parameters();
  EXPECT_EQ(p[m1], 1.1);
  EXPECT_EQ(p[c2], 0.02);
  eom::inputs r = eom::inputs::Zero();
  r[T2] = 3;
  EXPECT_EQ(r, Eigen::Vector2d(0, 3));
}

TEST(arguments, may_be_any_eigen_vectors) {
  const eom::state x = some_state();
  const eom::parameters p = some_parameters();
  const eom::inputs r(Eigen::Vector2d(1, 2));
  const auto expected = eom::udot(x, p, r);
  const double memory[]{9, 0.1, 0.2, 0.3, 0.4, 9};
  Eigen::Matrix<double, 10, 3> table;
  table.col(1) = p;
  no_heap::guard guard;
  EXPECT_EQ(eom::udot(Eigen::Map<const Eigen::Vector4d>(memory + 1), p, r), expected);
  EXPECT_EQ(eom::udot(Eigen::Vector4d(0.1, 0.2, 0.3, 0.4), table.col(1), r), expected);
  EXPECT_EQ(eom::udot(0.5 * (x + x), p, Eigen::Vector2d(0.5, 1) * 2), expected);
  EXPECT_EQ(eom::udot(0.0, x, p, r), expected);
}

} // namespace
