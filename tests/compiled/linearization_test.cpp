// builds: clang++
// Further results of compiled linearizations in addition to the matrices.
#include "models/four_bar.hpp"
#include "models/pendulum_nonminimal.hpp"
#include "no_heap.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace four_bar;
using lin = kanexpr::linearization<System>;

template <class Function, class... Arguments>
auto without_heap(Function function, const Arguments&... arguments) {
  no_heap::guard guard;
  return function(arguments...);
}

// Sensors: a dependent coordinate, a velocity and an acceleration, compared with finite differences of the
// measurements as the state moves along the constraints.
TEST(linearization, outputs_follow_the_state) {
  using eom = kanexpr::equations_of_motion<System>;
  constexpr kanexpr::function<System, q3, velocity_of<P3>, acceleration_of<P2>> measured{};
  lin::parameters p;
  p.setConstant(0.6);
  p[l0] = 2, p[l1] = 0.7, p[l2] = 1.8, p[l3] = 1.2, p[g] = 9.81;
  const auto values = [&](double q, double u, double torque) {
    lin::state x;
    x << q, -0.5, -2, u, 0, 0;
    lin::inputs r;
    r << torque;
    for (int i = 0; i < 30; ++i) {
      const auto gap = eom::configuration_residual(x, p);
      x.template segment<2>(1) -= eom::configuration_jacobian_by_dependent(x, p).inverse() * gap;
    }
    x.template tail<2>() = eom::dependent_speeds(x, p);
    const auto [angle, velocity, acceleration] = measured(x, p, r);
    Eigen::Matrix<double, 7, 1> all;
    all << angle, velocity, acceleration;
    return std::pair(x, all);
  };
  const double q = 0.9, u = 1.3, torque = 2, h = 1e-3;
  lin::inputs r;
  r << torque;
  const auto [C, D] =
      without_heap(lin::outputs<q3, velocity_of<P3>, acceleration_of<P2>>, values(q, u, torque).first, p, r);
  const auto slope = [&](double dq, double du, double dr) { // of eighth order
    const auto at = [&](double k) {
      return values(q + k * h * dq, u + k * h * du, torque + k * h * dr).second;
    };
    return Eigen::VectorXd((4 * (at(1) - at(-1)) / 5 - (at(2) - at(-2)) / 5 + 4 * (at(3) - at(-3)) / 105 -
                            (at(4) - at(-4)) / 280) /
                           h);
  };
  EXPECT_LE((C.col(0) - slope(1, 0, 0)).norm(), 1e-10 * C.norm());
  EXPECT_LE((C.col(1) - slope(0, 1, 0)).norm(), 1e-10 * C.norm());
  EXPECT_LE((D.col(0) - slope(0, 0, 1)).norm(), 1e-10 * D.norm());
  EXPECT_GT(D.norm(), 0.01);
}

TEST(linearization, says_where_its_states_stand) {
  EXPECT_EQ(lin::states, 2);
  EXPECT_EQ(lin::places, (std::array{0, 3}));
  Eigen::Matrix<double, 6, 1> order;
  order << 0, 3, 1, 2, 4, 5; // q1, u1, q2, q3, u2, u3
  EXPECT_EQ(lin::permutation() * order, (Eigen::Matrix<double, 6, 1>{0, 1, 2, 3, 4, 5}));
}

// A crank rotated to the position in which coupler and rocker are in line.
TEST(linearization, tells_where_there_is_none) {
  lin::state x;
  lin::parameters p;
  p.setOnes();
  x[q1] = 0.3;
  const auto [A, B] = without_heap(lin::explicit_form, x, p, lin::inputs::Zero());
  EXPECT_FALSE(A.status);
  EXPECT_EQ(A.status.cause(),
            "the constraints cannot be solved for the dependent speeds u2 and u3 at this state");
}

TEST(linearization, names_what_was_never_set) {
  lin::state x;
  x << 0.3, -0.5, -2, 1, 0, 0;
  lin::inputs r = lin::inputs::Zero();
  lin::parameters p;
  p.setOnes();
  p[m2] = lin::parameters()[m2];
  const auto [A, B] = without_heap(lin::explicit_form, x, p, r);
  EXPECT_EQ(A.status.cause(), "m2 has no finite value");
  EXPECT_EQ(B.status.cause(), "m2 has no finite value");
  p[m2] = 1;
  EXPECT_TRUE(std::get<0>(lin::explicit_form(x, p, r)).status);
  EXPECT_EQ(std::get<0>(lin::explicit_form(x, p, lin::inputs())).status.cause(), "T has no finite value");
  p[m2] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(std::get<0>(lin::explicit_form(0.0, x, p, r)).status);
}

template <int width>
constexpr bool windows_contain(unsigned pattern) {
  constexpr int size = 29;
  const auto is_in = [&](int i) { return (pattern >> i) % 2 != 0; };
  const kanexpr::compiled::windows<size, width> found(is_in);
  bool is_covered[size]{};
  for (int k = 0; k < found.count; ++k) {
    if (found.first[k] < 0 || found.first[k] + width > size) return false;
    for (int i = 0; i < width; ++i) is_covered[found.first[k] + i] = true;
  }
  for (int i = 0; i < size; ++i)
    if (is_in(i) && !is_covered[i]) return false;
  return pattern != 0 || found.count == 0;
}

// Only the entries that can differ from zero are checked, several at a time.
TEST(linearization, checks_every_entry_that_may_not_be_finite) {
  for (const unsigned pattern : {0U, 1U, 1U << 28, 0x1fffffffU, 0x10204080U, 0x0f0f0f0fU, 0x15555555U}) {
    EXPECT_TRUE(windows_contain<1>(pattern)) << pattern;
    EXPECT_TRUE(windows_contain<4>(pattern)) << pattern;
    EXPECT_TRUE(windows_contain<8>(pattern)) << pattern;
  }
}

/// Blocks on a line, each on a spring of its own: nearly all entries of A are zero.
namespace blocks {

using namespace kanexpr;

template <int i>
constexpr coordinate<"q", i> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr parameter<"w", i> w; // the root of the stiffness

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
template <int i>
struct Place : offset<Place<i>, O, q<i> * N::x> {};
template <int i>
struct Block : particle<Block<i>, Place<i>, 1> {};

template <int... i>
using row = kane_system<inertial<N>, coordinates<q<i>...>, speeds<u<i>...>,
                        kinematics<(dot(q<i>) == u<i>)...>, parameters<w<i>...>, bodies<Block<i>...>,
                        loads<force<Place<i>, -w<i> * w<i> * q<i> * N::x>...>>;
struct System : row<1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12> {};

} // namespace blocks

// So many entries are checked in windows. An overflow must be found wherever it is.
TEST(linearization, checks_every_entry_of_a_large_matrix) {
  using of_blocks = kanexpr::linearization<blocks::System>;
  const of_blocks::state x = of_blocks::state::Constant(0.1);
  const of_blocks::inputs r;
  of_blocks::parameters p;
  p.setOnes();
  EXPECT_TRUE(std::get<0>(without_heap(of_blocks::explicit_form, x, p, r)).status);
  for (int i = 0; i < 12; ++i) {
    p[i] = 1e200;
    const auto [A, B] = without_heap(of_blocks::explicit_form, x, p, r);
    EXPECT_EQ(A.status.cause(), "the results are not finite at this state") << i;
    EXPECT_EQ(A(12 + i, i), -std::numeric_limits<double>::infinity());
    p[i] = 1;
  }
}

// M is returned but not solved with; the other matrices depend on u̇ and the multipliers.
TEST(linearization, with_multipliers_tells_where_the_mass_matrix_is_singular) {
  namespace circle = pendulum_nonminimal;
  using on_circle = kanexpr::linearization<circle::LagrangeSystem>;
  on_circle::state x;
  x[circle::q1] = 0.8, x[circle::q2] = 0.6;
  on_circle::parameters p;
  p[circle::m] = 0, p[circle::L] = 1, p[circle::g] = 9.81;
  const auto [M, A, B] = on_circle::implicit_form(x, p, on_circle::inputs::Zero());
  EXPECT_EQ(A.status.cause(),
            "the mass matrix is singular at this state: its elimination fails at the rate of "
            "coordinate q2");
  p[circle::m] = 1;
  EXPECT_TRUE(std::get<1>(on_circle::implicit_form(x, p, on_circle::inputs::Zero())).status);
  p[circle::m] = on_circle::parameters()[circle::m];
  EXPECT_EQ(std::get<1>(on_circle::implicit_form(x, p, on_circle::inputs::Zero())).status.cause(),
            "m has no finite value");
}

} // namespace
