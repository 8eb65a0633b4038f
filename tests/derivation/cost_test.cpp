// builds: clang++
// The cost of the models must not increase.
#include <kanexpr/derivation/cost.hpp>
#include <models/iiwa.hpp>
#include <models/pendulum6.hpp>
#include <models/puma.hpp>
#include <models/quadruped.hpp>
#include <models/rolling_disc.hpp>

#include <gtest/gtest.h>

namespace {

using kanexpr::mechanics::quantity;

constexpr int operations(const kanexpr::symbolic::cost& c) { return c.multiplications + c.additions; }

using disc = kanexpr::equations_of_motion<rolling_disc::System>;
static_assert(disc::cost(disc::mass_matrix).multiplications <= 5);
static_assert(disc::cost(disc::mass_matrix).trigonometric == 0);

using pendulum = kanexpr::equations_of_motion<pendulum6::System>;
static_assert(operations(pendulum::together(pendulum::mass_matrix, pendulum::forcing).cost()) <= 190);
static_assert(operations(pendulum::cost(pendulum::udot)) <= 340);

template <class System>
int equations() {
  return operations(kanexpr::derivation::cost_of<System>({quantity::mass_matrix, quantity::forcing}));
}
template <class System>
int accelerations() {
  return operations(kanexpr::derivation::cost_of<System>({quantity::udot}));
}

TEST(cost, is_the_same_while_the_program_runs) {
  EXPECT_EQ(kanexpr::derivation::cost_of<pendulum6::System>({quantity::mass_matrix, quantity::forcing}),
            pendulum::together(pendulum::mass_matrix, pendulum::forcing).cost());
  EXPECT_EQ(kanexpr::derivation::cost_of<pendulum6::System>({quantity::udot}),
            pendulum::cost(pendulum::udot));
}

TEST(cost, of_robots) {
  EXPECT_LE(equations<puma::System>(), 690);
  EXPECT_LE(accelerations<puma::System>(), 840);
  EXPECT_LE(equations<iiwa::System>(), 525);
  EXPECT_LE(accelerations<iiwa::System>(), 715);
  EXPECT_LE(equations<quadruped::System>(), 1715);
  EXPECT_LE(accelerations<quadruped::System>(), 2890);
}

template <class System>
int linearization() {
  return operations(kanexpr::derivation::cost_of<System>({quantity::state_matrix, quantity::input_matrix}));
}

// Derivatives with respect to the angle of the iiwa's last joint are formed forward, those with respect to
// the others in reverse; all derivatives of the pendulum and of the quadruped are formed forward. Columns
// that are solved together take up to 5 % more operations than each for itself, and less time.
TEST(cost, of_linearizations) {
  EXPECT_LE(linearization<iiwa::System>(), 4190);
  EXPECT_LE(linearization<puma::System>(), 4150);
  EXPECT_LE(linearization<pendulum6::System>(), 1550);
  EXPECT_LE(linearization<quadruped::System>(), 17840);
}

TEST(cost, of_second_order) {
  EXPECT_LE(operations(kanexpr::derivation::cost_of<iiwa::System>({quantity::weighted_hessian})), 7670);
}

TEST(cost, of_more_than_there_is_room_for_is_a_mistake) {
  kanexpr::lower::tape_sizes sizes{.steps = kanexpr::lower::most_steps, .results = 9};
  EXPECT_FALSE(kanexpr::derivation::check_room("Chain", sizes));
  ++sizes.steps;
  EXPECT_EQ(kanexpr::derivation::check_room("Chain", sizes).view(),
            "the results requested from Chain take 131073 operations and have 9 entries; the limit is 131072 "
            "of each; "
            "request them in parts");
}

TEST(cost, of_more_causes_than_there_is_room_for_is_a_mistake) {
  const kanexpr::base::sentence cause({"M is singular"});
  const auto filled = [&](auto causes, int count) {
    for (int i = 0; i < count; ++i) causes.push(cause);
    return std::string(kanexpr::derivation::check_room("Chain", causes, cause).view());
  };
  const char* const told = "the results requested from Chain have more potential singularities than "
                           "supported; request them in parts";
  const kanexpr::derivation::cause_list<{2, 100}> few{};
  EXPECT_EQ(filled(few, 1), "");
  EXPECT_EQ(filled(few, 2), told);
  const kanexpr::derivation::cause_list<{9, 39}> short_ones{}; // three times thirteen letters
  EXPECT_EQ(filled(short_ones, 2), "");
  EXPECT_EQ(filled(short_ones, 3), told);
}

} // namespace
