// builds: all
#include "runtime/agreement.hpp"
#include "systems/check_robot_against_oracle.hpp"

#include <kanexpr/batch.hpp>
#include <models/iiwa.hpp>

#include <limits>

namespace {

using system = iiwa::System;

static_assert(check::robot_cost<system>() <= 730);

TEST(iiwa, agrees_with_the_oracle) { check::robot_against_oracle<system>("arm_iiwa"); }
TEST(iiwa, motors_bring_the_energy) { check::motors_bring_the_energy<system>("arm_iiwa"); }
TEST(iiwa, compiled_and_interpreted_results_are_identical) { agreement::check<system>(); }

TEST(iiwa, is_linearized_about_several_states_at_a_time) {
  using two = kanexpr::batch<2>;
  using linear = kanexpr::linearization<system>;
  two::state<system> x;
  two::inputs<system> r;
  for (int i = 0; i < x.size(); ++i) x(i) = two::number{0.1 * i - 0.4, 0.3 - 0.05 * i};
  for (int i = 0; i < r.size(); ++i) r(i) = two::number{1.0 - i, 0.5 * i};
  const kanexpr::parameter_values<system, two::number> numbers;
  const auto [A, B] = linear::explicit_form(x, numbers, r);
  ASSERT_TRUE(A.status && B.status);
  kanexpr::model derived = kanexpr::derive<system>();
  auto interpreted = derived.function(derived.get(kanexpr::mechanics::quantity::state_matrix));
  for (std::size_t lane = 0; lane < 2; ++lane) {
    const auto [own_A, own_B] = linear::explicit_form(two::get(x, lane), {}, two::get(r, lane));
    EXPECT_EQ(two::get(A, lane), own_A);
    EXPECT_EQ(two::get(B, lane), own_B);
    EXPECT_EQ(own_A, interpreted(two::get(x, lane), kanexpr::parameter_values<system>(), two::get(r, lane)));
  }
  // more than half of the entries are zero; the others are checked
  int failures = 0;
  for (int i = 0; i < x.size(); ++i) {
    auto broken = two::get(x, 0);
    broken(i) = std::numeric_limits<double>::infinity();
    const auto own_A = std::get<0>(linear::explicit_form(broken, {}, two::get(r, 0)));
    EXPECT_EQ(static_cast<bool>(own_A.status), own_A.allFinite()) << i;
    failures += own_A.status ? 0 : 1;
  }
  EXPECT_EQ(failures, 12); // the first and the last joint may take any angle
}

} // namespace
