// builds: clang++ all
// Compares second derivatives of steps with complex-step differentiation of the first ones.
#include "compiled/complex_steps.hpp"
#include "compiled/stirred_slider.hpp"

#include <kanexpr/steps/second_order_step.hpp>

#include <models/simple_pendulum.hpp>

#include <limits>

namespace {

using step_checks::MatrixXd;
using step_checks::VectorXd;

/// A bead on a rotated rail, whose speed is not the rate of a coordinate.
namespace bead {

using namespace kanexpr;

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"m"> m;
constexpr parameter<"k"> k;
constexpr input<"r"> push;
constexpr time_variable t;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct A : rotated<A, N, q1, N::z> {};
struct P : offset<P, O, q2 * A::x> {};
struct Bead : particle<Bead, P, m> {};
struct System
    : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>,
                  kinematics<dot(q1) == u1 / q2, dot(q2) == u2 + u1 * sin(q1)>, parameters<m, k>,
                  inputs<push>, bodies<Bead>,
                  loads<force<P, (push * cos(q2) - k * u2 * u1 - sin(t) * q2) * A::x + push * N::y>>> {};

} // namespace bead

/// ∂²(λᵀx⁺)/∂z².
template <class Step, class System>
MatrixXd by_complex_steps(const step_checks::point<System>& at, double h, const VectorXd& w) {
  using complex = std::complex<double>;
  constexpr double tiny = 1e-30;
  const Eigen::Index n = at.x.size(), inputs = at.r.size();
  MatrixXd all(n + inputs, n + inputs);
  for (Eigen::Index j = 0; j < n + inputs; ++j) {
    kanexpr::state<System, complex> x(at.x.template cast<complex>());
    kanexpr::input_values<System, complex> r(at.r.template cast<complex>());
    (j < n ? x(j) : r(j - n)) += complex(0, tiny);
    const auto next = kanexpr::linearized<Step>{}(at.t, x, h, at.p, r);
    EXPECT_TRUE(next.status);
    all.col(j) << (next.by_state.transpose() * w).imag() / tiny,
        (next.by_inputs.transpose() * w).imag() / tiny;
  }
  return all;
}

template <class Step, class System>
void expect_second_derivatives(const step_checks::point<System>& around, double h) {
  using second = kanexpr::second_order_step<Step>;
  using rates = kanexpr::second_order<System>;
  std::mt19937_64 source(5);
  for (int round = 0; round < 10; ++round) {
    const step_checks::point<System> at = step_checks::random_point(source, around, 0.5);
    const typename rates::template weights<> w = step_checks::random_numbers(source, at.x.size(), 1);
    const typename rates::template direction<> v = step_checks::random_numbers(source, rates::size, 1);
    const auto [hessian, product] = [&] {
      no_heap::guard guard;
      return std::pair(second::hessian(at.t, at.x, h, at.p, at.r, w),
                       second::hessian_product(at.t, at.x, h, at.p, at.r, w, v));
    }();
    ASSERT_TRUE(hessian.status) << hessian.status.cause();
    ASSERT_TRUE(product.status) << product.status.cause();
    const MatrixXd expected = by_complex_steps<Step>(at, h, w);
    EXPECT_LE((hessian - expected).norm(), 1e-12 * expected.norm());
    EXPECT_LE((product - expected * v).norm(), 1e-12 * expected.norm() * v.norm());
    EXPECT_EQ(hessian, hessian.transpose());
  }
}

step_checks::point<bead::System> bead_away_from_the_axis() {
  auto at = step_checks::plain_point<bead::System>();
  at.x[bead::q2] = 2;
  return at;
}

TEST(second_order_step, of_runge_kutta) {
  expect_second_derivatives<kanexpr::runge_kutta_4<bead::System, 0>>(bead_away_from_the_axis(), 0.1);
  expect_second_derivatives<kanexpr::ralston_3<bead::System, 0>>(bead_away_from_the_axis(), 0.1);
}

TEST(second_order_step, of_semi_implicit_euler) {
  expect_second_derivatives<kanexpr::semi_implicit_euler<bead::System, 0>>(bead_away_from_the_axis(), 0.1);
}

// Here q̇ has no second derivatives.
TEST(second_order_step, of_rates_as_speeds) {
  expect_second_derivatives<kanexpr::semi_implicit_euler<simple_pendulum::System, 0>>(
      step_checks::plain_point<simple_pendulum::System>(), 0.1);
}

TEST(second_order_step, of_state_variables) {
  using stirred_slider::FreeSystem;
  const auto around = step_checks::plain_point<FreeSystem>();
  expect_second_derivatives<kanexpr::runge_kutta_4<FreeSystem, 0>>(around, 0.1);
  expect_second_derivatives<kanexpr::semi_implicit_euler<FreeSystem, 0>>(around, 0.1);
}

TEST(second_order_step, tells_what_is_not_finite) {
  auto at = bead_away_from_the_axis();
  at.p[bead::k] = std::numeric_limits<double>::quiet_NaN();
  const auto found = kanexpr::second_order_step<kanexpr::semi_implicit_euler<bead::System, 0>>::hessian(
      at.t, at.x, 0.1, at.p, at.r, Eigen::Vector4d::Ones());
  EXPECT_EQ(found.status.cause(), "k has no finite value");
}

} // namespace
