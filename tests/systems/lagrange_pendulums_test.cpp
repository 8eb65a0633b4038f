// builds: clang++ sanitize all
#include "systems/check_lagrange.hpp"

#include <models/double_pendulum.hpp>
#include <models/pendulum_nonminimal.hpp>
#include <models/simple_pendulum.hpp>

namespace {

using namespace kanexpr;

check::numbers numbers_of(const std::string& name) { return oracle::load(name).parameters; }

TEST(lagrange, simple_pendulum) {
  using namespace simple_pendulum;
  check::lagrange_against_kane<System, LagrangeSystem, true>(numbers_of("simple_pendulum"), 3);
  check::lagrange_against_oracle<LagrangeSystem>("simple_pendulum");
}

TEST(lagrange, pendulum_nonminimal) {
  using namespace pendulum_nonminimal;
  const check::numbers values = numbers_of("pendulum_nonminimal");
  check::lagrange_against_kane<System, LagrangeSystem, true>(values, 0.5);
  check::keeps_its_energy<LagrangeSystem>(values, 0.5);
}

TEST(lagrange, double_pendulum) {
  using namespace double_pendulum;
  check::lagrange_against_kane<System, LagrangeSystem, false>(numbers_of("double_pendulum"), 3);
}

// The rates of the coordinates are in the state, in their order.
TEST(lagrange, state_holds_rates) {
  using namespace pendulum_nonminimal;
  using eom = equations_of_motion<LagrangeSystem>;
  eom::state x;
  x[q2] = 1;
  x[q1] = 2;
  x[dot(q2)] = 3;
  x[dot(q1)] = 4;
  EXPECT_EQ(x, Eigen::Vector4d(1, 2, 3, 4));
  const eom::state& same = x;
  EXPECT_EQ(same[dot(q1)], 4);
  static_assert(eom::is_dependent(dot(q1)) && !eom::is_dependent(dot(q2)));
  static_assert(eom::is_dependent(q1) && !eom::is_dependent(q2));
}

// At a level position, the rate of q1 does not follow from that of q2.
TEST(lagrange, names_the_rate_that_cannot_be_solved_for) {
  using namespace pendulum_nonminimal;
  using eom = equations_of_motion<LagrangeSystem>;
  eom::state x;
  x[q2] = 0.7;
  const auto udot =
      eom::udot(x, check::parameters_by_name<LagrangeSystem>(numbers_of("pendulum_nonminimal")));
  EXPECT_FALSE(udot.status);
  EXPECT_EQ(udot.status.cause(),
            "the constraints cannot be solved for the dependent rate of coordinate q1 at this state");
}

namespace off_the_circle {

using namespace pendulum_nonminimal;

constexpr auto k = constant<5, hertz>;
constexpr auto apart = q1 * q1 + q2 * q2 - L * L;
constexpr auto rate = 2 * q1 * dot(q1) + 2 * q2 * dot(q2);
constexpr auto second = 2 * (q1 * dot(dot(q1)) + q2 * dot(dot(q2)) + dot(q1) * dot(q1) + dot(q2) * dot(q2));

struct System : lagrange_system<inertial<N>, coordinates<q2, q1>, configuration_constraints<apart == 0>,
                                acceleration_constraints<second == -2 * k * rate - k * k * apart>,
                                bodies<Bob>, loads<gravity<g * N::x>>> {};

} // namespace off_the_circle

// Acceleration constraints contain second derivatives, and the motion satisfies them.
TEST(lagrange, takes_acceleration_constraints) {
  using namespace off_the_circle;
  using eom = equations_of_motion<System>;
  const auto p = check::parameters_by_name<System>(numbers_of("pendulum_nonminimal"));
  const eom::state x(0.3, -0.5, 1.2, 0.7);
  constexpr auto drawn_back = function<System, second + 2 * k * rate + k * k * apart>{};
  EXPECT_NEAR(check::without_heap(drawn_back, x, p).value, 0, 1e-13);
  const Eigen::Vector2d udot = eom::udot(x, p);
  const auto of_q1 = function<System, dot(dot(q1))>{}(x, p),
             same = function<System, derivative(dot(q1))>{}(x, p);
  EXPECT_EQ(of_q1.value, udot(1));
  EXPECT_EQ(same.value, udot(1));
}

// Rates may occur wherever speeds may.
TEST(lagrange, differentiates_by_rates) {
  using namespace simple_pendulum;
  using eom = equations_of_motion<LagrangeSystem>;
  eom::state x;
  x[q] = 0.4;
  eom::parameters p;
  p[l] = 2;
  const Eigen::Vector3d expected(-2 * std::sin(0.4), 2 * std::cos(0.4), 0);
  const Eigen::Vector3d found = function<LagrangeSystem, partial(velocity_of<P>, dot(q))>{}(x, p);
  EXPECT_TRUE(oracle::close(found, expected, 1e-15));
  const Eigen::Vector3d column = function<LagrangeSystem, jacobian(velocity_of<P>, dot(q))>{}(x, p);
  EXPECT_TRUE(oracle::close(column, expected, 1e-15));
}

} // namespace
