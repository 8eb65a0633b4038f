// builds: clang++
// The derivatives of the configuration constraints with respect to all coordinates.
#include "compiled/complex_steps.hpp"

#include <models/bicycle.hpp>
#include <models/four_bar.hpp>
#include <models/simple_pendulum.hpp>

namespace {

using step_checks::MatrixXd;

template <class System>
void is_that_of_residual() {
  using eom = kanexpr::equations_of_motion<System>;
  std::mt19937_64 source(4);
  for (int round = 0; round < 50; ++round) {
    const auto at = step_checks::random_point(source, step_checks::plain_point<System>(), 1);
    const MatrixXd expected =
        step_checks::derivatives(eom::configuration_residual, at).leftCols(eom::coordinates);
    const auto [whole, of_dependent] = eom::together(
        eom::configuration_jacobian_by_all, eom::configuration_jacobian_by_dependent)(at.x, at.p, at.r);
    EXPECT_GT(expected.norm(), 0.1);
    EXPECT_LE((whole - expected).norm(), 1e-13 * expected.norm());
    Eigen::Index column = 0;
    for (int j = 0; j < eom::coordinates; ++j) {
      if (!kanexpr::linearization<System>::known.dependent[j]) continue;
      EXPECT_EQ(whole.col(j), of_dependent.col(column++));
    }
    EXPECT_EQ(column, of_dependent.cols());
  }
}

TEST(configuration_jacobian, four_bar) { is_that_of_residual<four_bar::System>(); }
TEST(configuration_jacobian, four_bar_by_lagrange) { is_that_of_residual<four_bar::LagrangeSystem>(); }
TEST(configuration_jacobian, bicycle) { is_that_of_residual<bicycle::System>(); }

// One column for each coordinate, and no rows.
using free_eom = kanexpr::equations_of_motion<simple_pendulum::System>;
using nothing = decltype(free_eom::configuration_jacobian_by_all(free_eom::state(), free_eom::parameters()));
static_assert(nothing::RowsAtCompileTime == 0 && nothing::ColsAtCompileTime == 1);

} // namespace
