// builds: clang++ sanitize no-exceptions
#include "control/matrices.hpp"

#include <kanexpr/control/lqr.hpp>

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace kanexpr;
using references::close;

// For a double integrator, K = (√(q₁/r), √(q₂/r + 2 √(q₁/r))).
TEST(lqr, takes_weights_as_diagonals) {
  const Eigen::Matrix2d A{{0, 1}, {0, 0}};
  const Eigen::Vector2d B(0, 1);
  const Eigen::RowVector2d expected(2, std::sqrt(3 + 4));
  EXPECT_TRUE(close(lqr(A, B, {4, 3}, {1}).K, expected, 1e-14));
  EXPECT_TRUE(close(lqr(A, B, {4, 3}, 1).K, expected, 1e-14));
  EXPECT_TRUE(close(lqr(A, B, Eigen::Vector2d(4, 3), Eigen::Matrix<double, 1, 1>(1.0)).K, expected, 1e-14));
  EXPECT_TRUE(close(lqr(A, B, Eigen::Matrix2d{{4, 0}, {0, 3}}, {1}).K, expected, 1e-14));
  constexpr auto found =
      lqr(numeric::by_rows({{0.0, 1.0}, {0.0, 0.0}}), numeric::by_rows({{0.0}, {1.0}}), {4, 3}, {1});
  static_assert(found && found.K(0, 0) > 2 - 1e-14 && found.K(0, 0) < 2 + 1e-14);
}

constexpr std::string_view not_stabilizable = "the system is not stabilizable to working precision: "
                                              "its inputs do not reach a motion that does not decay";

template <class Regulator>
std::string cause(const Regulator& none) {
  EXPECT_FALSE(none);
  EXPECT_FALSE(none.K.allFinite());
  EXPECT_FALSE(none.P.allFinite());
  return none.status.cause();
}

TEST(lqr, says_that_a_system_is_not_stabilizable) {
  const Eigen::Vector3d B(1, 2, 0);
  for (const double rate : {0.0, 1e-3, 0.1, 1.0, 2.0, 1e3}) {
    const Eigen::Matrix3d A{{0.5, 1, 0.3}, {-1, 0.2, 0.1}, {0, 0, rate}};
    EXPECT_EQ(cause(lqr(A, B, {1, 1, 1}, {1})), not_stabilizable) << rate;
    EXPECT_EQ(cause(lqr(A, B, {0, 0, 0}, {1})), not_stabilizable) << rate;
  }
  for (const double factor : {1.0, -1.0, 1.001, 1.5, -10.0, 1e3}) {
    const Eigen::Matrix3d A{{0.5, 1, 0.3}, {-1, 0.2, 0.1}, {0, 0, factor}};
    EXPECT_EQ(cause(dlqr(A, B, {1, 1, 1}, {1})), not_stabilizable) << factor;
  }
  EXPECT_EQ(cause(lqr(Eigen::Matrix2d{{0, 1}, {-1, 0}}, Eigen::Vector2d(0, 0), {1, 1}, {1})),
            not_stabilizable);
  EXPECT_TRUE(lqr(Eigen::Matrix2d{{-1, 1}, {0, -2}}, Eigen::Vector2d(0, 0), {1, 1}, {1}));
}

// Numbers between −1 and 1, the same with every library.
class numbers {
public:
  double operator()() { return static_cast<double>(random_()) / static_cast<double>(random_.max()) * 2 - 1; }
  template <int rows, int columns>
  Eigen::Matrix<double, rows, columns> matrix() {
    Eigen::Matrix<double, rows, columns> m;
    for (double& entry : m.reshaped()) entry = (*this)();
    return m;
  }

private:
  std::mt19937 random_{7};
};

// The inputs do not reach two motions, one of which grows. In the given coordinates, their entries are zero;
// after a rotation, rounding reaches them.
TEST(lqr, finds_no_feedback_for_what_no_input_reaches) {
  numbers random;
  for (int k = 0; k < 500; ++k) {
    Eigen::Matrix<double, 5, 5> a = random.matrix<5, 5>();
    a.bottomLeftCorner<2, 3>().setZero();
    const double rate = std::pow(10, 2 * random());
    a.bottomRightCorner<2, 2>() = Eigen::Matrix2d{{rate, random()}, {0, -0.5}};
    Eigen::Matrix<double, 5, 2> b = random.matrix<5, 2>();
    b.bottomRows<2>().setZero();
    Eigen::Matrix<double, 5, 5> turn = Eigen::Matrix<double, 5, 5>::Identity();
    if (k % 2 == 1) turn += 0.4 * random.matrix<5, 5>();
    const Eigen::Matrix<double, 5, 5> turned = turn * a * turn.inverse();
    const Eigen::Matrix<double, 5, 2> inputs = turn * b;
    EXPECT_EQ(cause(lqr(turned, inputs, {1, 1, 1, 1, 1}, {1, 1})), not_stabilizable) << k;
    a(3, 3) += 1;
    const Eigen::Matrix<double, 5, 5> stepped = turn * a * turn.inverse();
    EXPECT_EQ(cause(dlqr(stepped, inputs, {1, 1, 1, 1, 1}, {1, 1})), not_stabilizable) << k;
  }
}

// The residual of the equation relative to its terms, in any units.
TEST(lqr, solves_its_equation_in_any_units) {
  numbers random;
  for (int k = 0; k < 500; ++k) {
    Eigen::Vector4d units;
    for (double& unit : units) unit = std::pow(10, 6 * random());
    const Eigen::Matrix4d to = units.asDiagonal(), from = units.cwiseInverse().asDiagonal();
    const Eigen::Matrix4d a = from * random.matrix<4, 4>() * to, root = random.matrix<4, 4>();
    const Eigen::Matrix4d q = to * (root * root.transpose() + 0.1 * Eigen::Matrix4d::Identity()) * to;
    const Eigen::Matrix<double, 4, 2> b = from * random.matrix<4, 2>();
    const Eigen::Vector2d r(std::pow(10, random()), std::pow(10, random()));
    const auto found = lqr(a, b, q, r);
    ASSERT_TRUE(found) << found.status;
    const Eigen::Matrix4d xa = found.P * a, kk = found.K.transpose() * r.asDiagonal() * found.K;
    const Eigen::Matrix4d left = from * (q + xa + xa.transpose() - kk) * from;
    const Eigen::Matrix4d terms = from * (q.cwiseAbs() + 2 * xa.cwiseAbs() + kk.cwiseAbs()) * from;
    EXPECT_LE(left.norm(), 1e-9 * terms.norm()) << k;
    const auto step = dlqr(a, b, q, r);
    ASSERT_TRUE(step) << step.status;
    const Eigen::Matrix4d after = a.transpose() * step.P * (a - b * step.K);
    const Eigen::Matrix4d of_step = from * (q + after - step.P) * from;
    EXPECT_LE(of_step.norm(), 1e-9 * (from * step.P * from).norm()) << k;
  }
}

TEST(lqr, says_that_a_motion_has_no_weight) {
  constexpr std::string_view on_axis = "the system is not detectable on the imaginary axis: the state "
                                       "weights do not cover a motion that neither grows nor decays",
                             on_circle = "the system is not detectable on the unit circle: the state weights "
                                         "do not cover a motion that neither grows nor decays";
  const Eigen::Matrix2d integrators{{0, 1}, {0, 0}}, oscillator{{0, 1}, {-4, 0}};
  const Eigen::Vector2d B(0, 1);
  EXPECT_EQ(cause(lqr(integrators, B, {0, 0}, {1})), on_axis);
  EXPECT_EQ(cause(lqr(integrators, B, {0, 1}, {1})), on_axis);
  EXPECT_TRUE(lqr(integrators, B, {1, 0}, {1}));
  EXPECT_EQ(cause(lqr(oscillator, B, {0, 0}, {1})), on_axis);
  const double c = std::cos(0.3), s = std::sin(0.3);
  EXPECT_EQ(cause(dlqr(Eigen::Matrix2d{{c, s}, {-s, c}}, B, {0, 0}, {1})), on_circle);
  EXPECT_EQ(cause(dlqr(Eigen::Matrix2d{{1, 0.1}, {0, 1}}, B, {0, 1}, {1})), on_circle);
  EXPECT_EQ(cause(dlqr(Eigen::Matrix2d{{-1, 0}, {0, 0.5}}, Eigen::Vector2d(1, 1), {0, 1}, {1})), on_circle);
}

TEST(lqr, says_what_is_wrong_with_its_matrices) {
  const double infinite = std::numeric_limits<double>::infinity(),
               none = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Matrix2d A{{0, 1}, {2, 0}}, Q = Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d B = Eigen::Matrix2d::Identity();
  EXPECT_EQ(cause(lqr((infinite * Q).eval(), B, Q, Q)), "the state matrix A is not finite");
  EXPECT_EQ(cause(lqr(A, (none * Q).eval(), Q, Q)), "the input matrix B is not finite");
  EXPECT_EQ(cause(lqr(A, B, {1, none}, Q)), "the weights of the states are not finite");
  EXPECT_EQ(cause(lqr(A, B, Q, {infinite, 1})), "the weights of the inputs are not finite");
  EXPECT_EQ(cause(lqr(A, B, Eigen::Matrix2d{{1, 0.1}, {0, 1}}, Q)),
            "the weights of the states are not symmetric");
  EXPECT_EQ(cause(lqr(A, B, Q, Eigen::Matrix2d{{1, 0.1}, {0, 1}})),
            "the weights of the inputs are not symmetric");
  constexpr std::string_view indefinite = "the weights of the states are not positive semidefinite";
  EXPECT_EQ(cause(lqr(A, B, {1, -1e-9}, Q)), indefinite);
  EXPECT_EQ(cause(lqr(A, B, Eigen::Matrix2d{{1, 2}, {2, 1}}, Q)), indefinite);
  EXPECT_EQ(cause(lqr(A, B, Eigen::Matrix2d{{0, 1e-3}, {1e-3, 1}}, Q)), indefinite);
  EXPECT_EQ(cause(lqr(A, B, Eigen::Matrix2d{{0, 1e-200}, {1e-200, 0}}, Q)), indefinite);
  EXPECT_TRUE(lqr(A, B, Eigen::Matrix2d{{1e12, 1}, {1, 1e-12}}, Q));
  EXPECT_TRUE(lqr(A, B, Eigen::Matrix2d{{1, 0.1}, {0.1, 0.01}}, Q));
  EXPECT_EQ(cause(lqr(A, B, Q, {1, 0})), "the weights of the inputs are not positive definite");
  EXPECT_EQ(cause(lqr(A, B, Q, Eigen::Matrix2d{{1, 2}, {2, 1}})),
            "the weights of the inputs are not positive definite");
}

TEST(lqr, passes_on_the_status_of_a_matrix) {
  const with_status<Eigen::Matrix2d> A{Eigen::Matrix2d{{0, 1}, {2, 0}}, status("there is no A")};
  EXPECT_EQ(cause(lqr(A, Eigen::Vector2d(0, 1), {1, 1}, {1})), "there is no A");
  const with_status<Eigen::Vector2d> B{Eigen::Vector2d(0, 1), status("there is no B")};
  EXPECT_EQ(cause(dlqr(Eigen::Matrix2d(A), B, {1, 1}, {1})), "there is no B");
}

constexpr auto none =
    lqr(numeric::by_rows({{1.0, 0.0}, {0.0, 2.0}}), numeric::by_rows({{0.0}, {1.0}}), {1, 1}, {1});
static_assert(none.status.cause() == not_stabilizable);

} // namespace
