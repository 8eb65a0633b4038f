// builds: clang++ all
// Most kinds of loads in two systems: compiled and interpreted code to the last bit, single precision,
// batches, constant expressions, linearization, second derivatives and the forces of the loads.
#include "compiled/complex_steps.hpp"
#include "runtime/agreement.hpp"
#include "runtime/driven_wheel.hpp"
#include "runtime/loaded_arm.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/compiled/constant_values.hpp>

namespace {

using namespace kanexpr;
using namespace loaded_arm;
using eom = equations_of_motion<System>;

TEST(agreement, of_most_loads) {
  static_assert(eom::state_variables == 2);
  agreement::check<System>();
}

const eom::parameters numbers{{k, 20}, {c, 0.5}, {mu, 0.4}};
const eom::inputs volts{{V, 3}};
constexpr double angles[]{0.4, -0.7, 0.2, -0.5, 0.3, 0.01};
eom::state some_state(double turned = 0) {
  eom::state x;
  for (int i = 0; i < 6; ++i) x(i) = angles[i];
  x(0) += turned;
  return x;
}

TEST(agreement, of_most_loads_in_constant_expressions) {
  constexpr auto x = constant_state<System>({{q_of<Upper>, angles[0]},
                                             {q_of<Fore>, angles[1]},
                                             {u_of<Upper>, angles[2]},
                                             {u_of<Fore>, angles[3]},
                                             {current_of<Upper>, angles[4]},
                                             {bristle_of<Fore>, angles[5]}});
  constexpr auto rates = eom::rhs.constant(x, constant_parameters<System>({{k, 20}, {c, 0.5}, {mu, 0.4}}),
                                           constant_inputs<System>({{V, 3}}));
  const eom::state called = eom::rhs(some_state(), numbers, volts);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(rates(i), called(i), 1e-13 * (1 + called.norm()));
}

TEST(agreement, of_most_loads_in_batches_and_in_single_precision) {
  using two = batch<2>;
  two::state<System> both;
  two::set(both, 0, some_state()), two::set(both, 1, some_state(0.6));
  const auto found = eom::rhs(both, numbers, volts);
  EXPECT_EQ(two::get(found, 0), eom::rhs(some_state(), numbers, volts));
  EXPECT_EQ(two::get(found, 1), eom::rhs(some_state(0.6), numbers, volts));
  const eom::state exact = eom::rhs(some_state(), numbers, volts);
  const Eigen::VectorXf single =
      eom::rhs(some_state().cast<float>().eval(), numbers.cast<float>().eval(), volts.cast<float>().eval());
  EXPECT_LE((single.cast<double>() - exact).norm(), 1e-4 * exact.norm());
}

TEST(agreement, of_derivatives_of_most_loads) {
  step_checks::jacobian_is_that_of_rhs<System>();
  model m = derive<System>();
  auto forces = m.function(m.get<normal_force_of<Floor>>());
  EXPECT_EQ((function<System, normal_force_of<Floor>>{}(some_state(), numbers, volts)),
            forces(some_state(), numbers, volts)(0));
}

// A tyre on uneven ground, a muscle, a motor and its controller, and a foot with bristles.
namespace wheel {

using driven_wheel::System;
using eom = equations_of_motion<System>;

const eom::parameters numbers(1e4, 0.9, 300, 0.2);
const eom::inputs wanted(2, 0.3);
eom::state some_state(double raised = 0) {
  eom::state x = eom::state::Constant(0.1);
  x.head<10>() << 0.2, 0.1, 0.31 + raised, 0.5, -0.1, 0.6, 0.03, -0.1, 2.5, 0.3;
  x.tail<9>() *= 0.3;
  return x;
}

TEST(agreement, of_a_driven_wheel) {
  model m = derive<System>();
  ASSERT_EQ(m.mistake(), "");
  auto interpreted = m.function(m.rhs());
  const eom::state low = some_state(), high = some_state(0.1);
  const eom::state rates = eom::rhs(low, numbers, wanted);
  ASSERT_TRUE(rates.allFinite());
  agreement::expect_same_bits(rates, interpreted(low, numbers, wanted));
  using two = batch<2>;
  two::state<System> both;
  two::set(both, 0, low), two::set(both, 1, high);
  const auto found = eom::rhs(both, numbers, wanted);
  EXPECT_EQ(two::get(found, 0), rates);
  EXPECT_EQ(two::get(found, 1), eom::rhs(high, numbers, wanted));
  const Eigen::VectorXf x = low.cast<float>(), p = numbers.cast<float>(), r = wanted.cast<float>();
  const Eigen::VectorXf single =
      eom::rhs(low.cast<float>().eval(), numbers.cast<float>().eval(), wanted.cast<float>().eval());
  EXPECT_EQ(single, m.function<float>(m.rhs())(x, p, r));
}

TEST(agreement, of_derivatives_of_a_driven_wheel) {
  using complex = std::complex<double>;
  model m = derive<System>();
  auto rates = m.function<complex>(m.rhs());
  auto jacobian = m.function(m.get(mechanics::quantity::state_jacobian));
  for (const double raised : {0.0, 0.1}) {
    const eom::state x = some_state(raised);
    const Eigen::MatrixXd slope = jacobian(x, numbers, wanted);
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      Eigen::VectorXcd moved = x.cast<complex>();
      moved(j) += complex(0, 1e-30);
      const Eigen::VectorXd column = Eigen::VectorXcd(rates(moved, numbers, wanted)).imag() / 1e-30;
      EXPECT_LE((slope.col(j) - column).norm(), 1e-12 * (1 + column.norm())) << j;
    }
  }
}

} // namespace wheel

} // namespace
