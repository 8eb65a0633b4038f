// builds: clang++ all
// Second derivatives of weighted rates, compared with complex steps of the first derivatives at random states
// that violate the constraints; compiled and run-time results agree to the last bit.
#include "runtime/second_order.hpp"

#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/pivot_body.hpp>
#include <models/rocket.hpp>
#include <models/rolling_disc_constrained.hpp>

namespace {

using namespace to_second_order;

TEST(second_order, double_pendulum) {
  expect_second_order(derivatives(kanexpr::derive<double_pendulum::System>()), 3);
}
TEST(second_order, rocket) { expect_second_order(derivatives(kanexpr::derive<rocket::System>())); }
TEST(second_order, iiwa) { expect_second_order(derivatives(kanexpr::derive<iiwa::System>()), 3); }
TEST(second_order, rolling_disc) {
  expect_second_order(derivatives(kanexpr::derive<rolling_disc_constrained::System>()));
}
TEST(second_order, rolling_disc_by_lagrange) {
  expect_second_order(derivatives(kanexpr::derive<rolling_disc_constrained::LagrangeSystem>()));
}
TEST(second_order, four_bar) { expect_second_order(derivatives(kanexpr::derive<four_bar::System>())); }
TEST(second_order, pivot_body) {
  derivatives of(kanexpr::derive<pivot_body::System>());
  of.quaternion = 0;
  expect_second_order(std::move(of));
}

TEST(second_order, is_the_same_in_the_compiler) {
  using system = double_pendulum::System;
  using compiled = kanexpr::second_order<system>;
  std::mt19937_64 source(3);
  const auto x = agreement::random<compiled::state>(source, -3, 3);
  const auto p = agreement::random<compiled::parameters>(source, 0.5, 2);
  const auto r = agreement::random<compiled::inputs>(source, -5, 5);
  const auto w = agreement::random<compiled::weights<>>(source, -1, 1);
  const auto v = agreement::random<compiled::direction<>>(source, -1, 1);
  const auto each = [](quantity wanted) {
    auto m = kanexpr::derive<system>();
    return m.function(m.get(wanted));
  };
  agreement::expect_same_bits(compiled::hessian(x, p, r, w), each(quantity::weighted_hessian)(0, x, p, r, w));
  agreement::expect_same_bits(compiled::hessian_product(x, p, r, w, v),
                              each(quantity::weighted_hessian_product)(0, x, p, r, w, v));
  agreement::expect_same_bits(compiled::gradient(x, p, r, w),
                              each(quantity::weighted_gradient)(0, x, p, r, w));
  auto m = kanexpr::derive<system>();
  agreement::expect_same_bits(
      kanexpr::sensitivity<system, double_pendulum::m1, double_pendulum::g>(x, p, r),
      m.function(m.sensitivity<double_pendulum::m1, double_pendulum::g>())(0, x, p, r));
  agreement::expect_same_bits(compiled::directional_derivative(x, p, r, v),
                              each(quantity::directional_derivative)(0, x, p, r, v));
}

// Compared with complex steps along the parameters.
TEST(second_order, sensitivity) {
  auto m = kanexpr::derive<four_bar::System>();
  auto found = m.function(m.sensitivity<four_bar::l1, four_bar::g>());
  auto rhs = m.function<complex>(m.rhs());
  ASSERT_EQ(m.mistake(), "");
  std::mt19937_64 source(5);
  const VectorXd x = random_numbers(source, 6, 1), r = random_numbers(source, 1, 1);
  const Index count = m.mechanism().parameters.size();
  const VectorXd p = VectorXd::Ones(count) + random_numbers(source, count, 0.5);
  const MatrixXd by_parameters = found(0, x, p, r);
  for (const auto& [column, name] : {std::pair(0, "l1"), std::pair(1, "g")}) {
    VectorXcd there = p;
    there(m.known()->place(kanexpr::symbolic::symbol_kind::parameter, kanexpr::base::name(name))) +=
        complex(0, step);
    const VectorXd expected = rhs(0, x, there, r).imag() / step;
    EXPECT_LE((by_parameters.col(column) - expected).norm(), 1e-12 * expected.norm());
  }
}

TEST(second_order, sensitivity_is_by_parameters) {
  auto m = kanexpr::derive<double_pendulum::System>();
  EXPECT_EQ(m.sensitivity<double_pendulum::q1>().entries.size(), 0);
  EXPECT_EQ(m.mistake(), "a sensitivity is requested with respect to q1; it must be a parameter");
}

} // namespace
