// builds: clang++
// Discrete forms compared with 60-digit results. references.py reports the errors of SciPy.
// builds: clang++ sanitize
#include "control/matrices.hpp"
#include "control/references.hpp"
#include "no_heap.hpp"

#include <kanexpr/control/lqr.hpp>

#include <models/simple_pendulum.hpp>

#include <kanexpr/compiled/linearization.hpp>

#include <limits>

namespace {

using namespace kanexpr;
using references::close;
using references::eigen;
namespace forms = references::discrete_forms;

template <int n, int m>
void agrees(const references::discrete<n, m>& known, double relative) {
  const auto a = eigen(known.a);
  const auto b = eigen(known.b);
  const auto c = eigen(known.c);
  const auto found = [&] {
    no_heap::guard guard;
    return discretize(a, b, c, known.h);
  }();
  ASSERT_TRUE(found) << found.status;
  EXPECT_TRUE(close(found.A, eigen(known.ad), relative));
  EXPECT_TRUE(close(found.B, eigen(known.bd), relative));
  EXPECT_TRUE(close(found.c, eigen(known.cd), relative));
  const auto single = discretize(eigen<float>(known.a), eigen<float>(known.b), eigen<float>(known.c),
                                 static_cast<float>(known.h));
  ASSERT_TRUE(single) << single.status;
  const double rounding = relative * 0x1p29;
  EXPECT_TRUE(close(single.A.template cast<double>(), eigen(known.ad), rounding));
  EXPECT_TRUE(close(single.B.template cast<double>(), eigen(known.bd), rounding));
}

TEST(discretize, agrees_with_many_digits) {
  agrees(forms::of_random, 1e-14);
  agrees(forms::of_a_long_step, 1e-13);
  agrees(forms::of_a_double_integrator, 1e-15);
  agrees(forms::of_a_stiff_system, 1e-12);
  agrees(forms::of_an_oscillation, 1e-13);
  agrees(forms::in_units, 1e-14);
  agrees(forms::of_a_short_step, 1e-15);
}

constexpr const auto& known = forms::of_random;
constexpr auto by_the_compiler =
    discretize(references::fixed<double>(known.a), references::fixed<double>(known.b),
               references::fixed<double>(known.c), known.h);
static_assert(by_the_compiler);

TEST(discretize, is_the_same_in_a_constant_expression) {
  const auto found = discretize(eigen(known.a), eigen(known.b), eigen(known.c), known.h);
  EXPECT_TRUE(close(numeric::as_eigen(by_the_compiler.A), found.A, 1e-15));
  EXPECT_TRUE(close(numeric::as_eigen(by_the_compiler.B), found.B, 1e-15));
  EXPECT_TRUE(close(numeric::as_eigen(by_the_compiler.c), found.c, 1e-15));
}

// A linearization that is a constant.
constexpr auto of_a_linearization = discretize(
    linearization<simple_pendulum::System>::explicit_form.constant({0, 0}, {1, 1, 4, 0}, {0}), 0.5);
static_assert(of_a_linearization);

TEST(discretize, takes_a_constant_linearization) {
  EXPECT_NEAR(of_a_linearization.A(0, 0), std::cos(1), 1e-15);
  EXPECT_NEAR(of_a_linearization.B(1, 0), std::sin(1) / 2, 1e-15);
}

TEST(discretize, without_an_offset_has_none) {
  const auto found = discretize(eigen(known.a), eigen(known.b), known.h);
  EXPECT_TRUE(found.c.isZero(0));
  EXPECT_EQ(found.B, discretize(eigen(known.a), eigen(known.b), eigen(known.c), known.h).B);
}

// A pendulum near its lower equilibrium: an oscillation of the frequency √(g/l).
TEST(discretize, takes_a_linearization) {
  using lin = linearization<simple_pendulum::System>;
  const lin::state x;
  const lin::parameters p(2, 0.5, 9.81, 0);
  const lin::inputs r(0.0);
  const auto [Ad, Bd, cd, status] = discretize(lin::explicit_form(x, p, r), 0.1);
  ASSERT_TRUE(status);
  const double w = std::sqrt(9.81 / 0.5), angle = 0.1 * w;
  const Eigen::Matrix2d expected{{std::cos(angle), std::sin(angle) / w},
                                 {-w * std::sin(angle), std::cos(angle)}};
  EXPECT_TRUE(close(Ad, expected, 1e-15));
  EXPECT_TRUE(
      close(Bd, Eigen::Vector2d((1 - std::cos(angle)) / (w * w), std::sin(angle) / w) / (2 * 0.25), 1e-14));
  EXPECT_TRUE(cd.isZero(0));

  const auto [a, b] = lin::explicit_form(x, lin::parameters(), r);
  EXPECT_EQ(discretize(a, b, 0.1).status.cause(), "m has no finite value");
  EXPECT_EQ(discretize(lin::explicit_form(x, lin::parameters(), r), 0.1).status.cause(),
            "m has no finite value");
}

// The regulators accept the results of both directly, with their statuses.
TEST(lqr, takes_a_linearization_and_its_discrete_form) {
  using lin = linearization<simple_pendulum::System>;
  const lin::state x;
  const lin::parameters p(2, 0.5, 9.81, 0);
  const lin::inputs r(0.0);
  const auto [a, b] = lin::explicit_form(x, p, r);
  EXPECT_EQ(lqr(lin::explicit_form(x, p, r), {10, 1}, {0.1}).K, lqr(a, b, {10, 1}, {0.1}).K);
  const auto form = discretize(a, b, 0.1);
  EXPECT_EQ(dlqr(form, {10, 1}, {0.1}).K, dlqr(form.A, form.B, {10, 1}, {0.1}).K);
  const auto unknown = lin::explicit_form(x, lin::parameters(), r);
  EXPECT_EQ(lqr(unknown, {10, 1}, {0.1}).status.cause(), "m has no finite value");
  EXPECT_EQ(dlqr(discretize(unknown, 0.1), {10, 1}, {0.1}).status.cause(), "m has no finite value");

  constexpr auto constant = lqr(lin::explicit_form.constant({0, 0}, {1, 1, 4, 0}, {0}), {10, 1}, {0.1});
  static_assert(constant);
}

// Weights of lower precision are converted exactly.
TEST(lqr, takes_weights_of_fewer_digits) {
  const Eigen::Matrix2d a{{0, 1}, {0, 0}};
  const Eigen::Vector2d b(0, 1);
  const auto expected = lqr(a, b, {4, 3}, {1});
  EXPECT_EQ(lqr(a, b, Eigen::Vector2f(4, 3), Eigen::Matrix<float, 1, 1>(1)).K, expected.K);
  EXPECT_EQ(lqr(a, b, Eigen::Vector2i(4, 3), {1}).K, expected.K);
  EXPECT_EQ(lqr(a, b, numeric::by_rows({{4.0f, 0.0f}, {0.0f, 3.0f}}), {1}).K, expected.K);
}

TEST(discretize, passes_on_the_status_of_a_matrix) {
  const with_status<Eigen::Matrix2d> a{Eigen::Matrix2d::Identity(), status("there is no A")};
  const auto none = discretize(a, Eigen::Vector2d(1, 2), 0.1);
  EXPECT_EQ(none.status.cause(), "there is no A");
  EXPECT_FALSE(none.A.allFinite());
}

TEST(discretize, says_what_is_not_finite) {
  const double infinite = std::numeric_limits<double>::infinity();
  const Eigen::Matrix2d a = Eigen::Matrix2d::Identity();
  const Eigen::Vector2d b(1, 2);
  const auto cause = [](const auto& form) {
    EXPECT_FALSE(form);
    EXPECT_FALSE(form.A.allFinite());
    EXPECT_FALSE(form.B.allFinite());
    return form.status.cause();
  };
  EXPECT_EQ(cause(discretize(a, b, infinite)), "the step length is not finite");
  EXPECT_EQ(cause(discretize((infinite * a).eval(), b, 0.1)), "the state matrix A is not finite");
  EXPECT_EQ(cause(discretize(a, (infinite * b).eval(), 0.1)), "the input matrix B is not finite");
  EXPECT_EQ(cause(discretize(a, b, (infinite * b).eval(), 0.1)), "the offset c is not finite");
  EXPECT_EQ(cause(discretize(a, b, 1e4)), "the motion of the linear system over the step overflows");
}

} // namespace
