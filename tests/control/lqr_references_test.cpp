// builds: clang++ all
// Linear-quadratic regulators compared with those of SciPy, refined to full accuracy. references.py reports
// the errors of SciPy.
// builds: clang++ sanitize
#include "control/matrices.hpp"
#include "control/references.hpp"
#include "no_heap.hpp"

#include <kanexpr/control/lqr.hpp>

#include <Eigen/LU>

#include <cmath>

namespace {

using namespace kanexpr;
using Eigen::MatrixXd;
using references::close;
using references::eigen;
using references::fixed;

template <bool continuous, class A, class B, class Q, class R>
constexpr auto regulator(const A& a, const B& b, const Q& q, const R& r) {
  if constexpr (continuous)
    return lqr(a, b, q, r);
  else
    return dlqr(a, b, q, r);
}

struct expectation {
  MatrixXd a, b, r, x;
};
struct result {
  MatrixXd K, P;
};

// For matrices of any size, so that this code is compiled once.
void expect_agreement(const result& found, const expectation& known, bool continuous, double relative) {
  const auto& [a, b, r, x] = known;
  // Relative to the magnitudes of their rows and columns, which does not depend on the units; if some vanish,
  // relative to the largest.
  const bool some_vanish = x.diagonal().minCoeff() < 1e-99 * x.norm();
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    for (Eigen::Index j = 0; j < x.cols(); ++j)
      EXPECT_NEAR(found.P(i, j), x(i, j), relative * (some_vanish ? x.norm() : std::sqrt(x(i, i) * x(j, j))));
  MatrixXd gain = r.inverse() * b.transpose() * x;
  if (!continuous) gain = (r + b.transpose() * x * b).inverse() * b.transpose() * x * a;
  EXPECT_TRUE(close(found.K, gain, 10 * relative));
}

template <bool continuous, int n, int m>
void agrees(const references::riccati<n, m>& known, double relative) {
  const auto found = [&] {
    const auto a = eigen(known.a);
    const auto b = eigen(known.b);
    const auto q = eigen(known.q);
    const auto r = eigen(known.r);
    no_heap::guard guard;
    return regulator<continuous>(a, b, q, r);
  }();
  ASSERT_TRUE(found) << found.status;
  expect_agreement({found.K, found.P}, {eigen(known.a), eigen(known.b), eigen(known.r), eigen(known.x)},
                   continuous, relative);
}

template <bool continuous, int n, int m>
void agrees_in_single_precision(const references::riccati<n, m>& known, double relative) {
  const auto found = regulator<continuous>(eigen<float>(known.a), eigen<float>(known.b),
                                           eigen<float>(known.q), eigen<float>(known.r));
  ASSERT_TRUE(found) << found.status;
  const MatrixXd P = found.P.template cast<double>(), expected = eigen(known.x);
  EXPECT_TRUE(close(P, expected, relative));
}

TEST(lqr, agrees_with_scipy) {
  namespace known = references::continuous;
  agrees<true>(known::random_1, 1e-13);
  agrees<true>(known::random_2, 1e-12);
  agrees<true>(known::random_3, 1e-12);
  agrees<true>(known::random_4, 1e-12);
  agrees<true>(known::random_6, 1e-12);
  agrees<true>(known::random_8, 1e-12);
  agrees<true>(known::integrators, 1e-12);
}
TEST(lqr, agrees_with_scipy_where_it_is_hard) {
  namespace known = references::continuous;
  agrees<true>(known::large_units, 1e-12);
  agrees<true>(known::small_units, 1e-12);
  agrees<true>(known::nearly_unstabilizable, 1e-9);
  agrees<true>(known::unweighted, 1e-12);
  agrees<true>(known::close_to_the_axis_3, 1e-11);
  agrees<true>(known::close_to_the_axis_5, 1e-9);
  agrees<true>(known::stiff, 1e-9);
}
TEST(dlqr, agrees_with_scipy) {
  namespace known = references::discrete_time;
  agrees<false>(known::random_1, 1e-13);
  agrees<false>(known::random_2, 1e-12);
  agrees<false>(known::random_3, 1e-12);
  agrees<false>(known::random_4, 1e-12);
  agrees<false>(known::random_6, 1e-12);
  agrees<false>(known::random_8, 1e-11);
  agrees<false>(known::integrators, 1e-12);
}
TEST(dlqr, agrees_with_scipy_where_it_is_hard) {
  namespace known = references::discrete_time;
  agrees<false>(known::large_units, 1e-12);
  agrees<false>(known::small_units, 1e-12);
  agrees<false>(known::nearly_unstabilizable, 1e-9);
  agrees<false>(known::unweighted, 1e-12);
  agrees<false>(known::close_to_the_axis_3, 1e-11);
  agrees<false>(known::close_to_the_axis_5, 1e-9);
  agrees<false>(known::stiff, 1e-9);
}

TEST(lqr, agrees_in_single_precision) {
  agrees_in_single_precision<true>(references::continuous::random_4, 1e-4);
  agrees_in_single_precision<true>(references::continuous::integrators, 1e-4);
  agrees_in_single_precision<true>(references::continuous::small_units, 1e-4);
  agrees_in_single_precision<false>(references::discrete_time::random_4, 2e-4);
  agrees_in_single_precision<false>(references::discrete_time::integrators, 1e-4);
}

template <bool continuous, int n, int m>
constexpr auto by_the_compiler(const references::riccati<n, m>& known) {
  return regulator<continuous>(fixed<double>(known.a), fixed<double>(known.b), fixed<double>(known.q),
                               fixed<double>(known.r));
}

constexpr auto continuous_gain = by_the_compiler<true>(references::continuous::random_4);
constexpr auto discrete_gain = by_the_compiler<false>(references::discrete_time::random_3);
static_assert(continuous_gain && discrete_gain);

TEST(lqr, is_the_same_in_a_constant_expression) {
  EXPECT_TRUE(close(numeric::as_eigen(continuous_gain.P), eigen(references::continuous::random_4.x), 1e-12));
  EXPECT_TRUE(close(numeric::as_eigen(discrete_gain.P), eigen(references::discrete_time::random_3.x), 1e-12));
}

} // namespace
