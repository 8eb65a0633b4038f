// builds: clang++ all
// Lagrangians written by hand, with additional forces, compared with those derived from bodies.
#include "systems/check_constrained.hpp"

#include <models/double_pendulum.hpp>
#include <models/simple_pendulum.hpp>

namespace {

using namespace kanexpr;

check::numbers numbers_of(const std::string& name) { return oracle::load(name).parameters; }

namespace simple {

using namespace simple_pendulum;

struct ByHand
    : lagrange_system<inertial<N>, coordinates<q>, lagrangian<m * pow(l* dot(q), 2) / 2 + m * g * l * cos(q)>,
                      parameters<m, l, g, c>, inputs<T>, loads<torque<A, (T - c * dot(q)) * N::z>>> {};

} // namespace simple

namespace twofold {

using namespace double_pendulum;

constexpr auto w1 = dot(q1);
constexpr auto w2 = dot(q1) + dot(q2);
constexpr auto kinetic = (I1 + m1 * d1 * d1 + m2 * l1 * l1) * w1 * w1 / 2 +
                         (I2 + m2 * d2 * d2) * w2 * w2 / 2 + m2 * l1 * d2 * cos(q2) * w1 * w2;
constexpr auto potential = (m1 * d1 + m2 * l1) * g * sin(q1) + m2 * g * d2 * sin(q1 + q2);

struct ByHand
    : lagrange_system<
          inertial<N>, coordinates<q1, q2>, lagrangian<kinetic - potential>,
          parameters<m1, m2, d1, d2, l1, I1, I2, g, c1, c2>, inputs<T1, T2>,
          loads<torque<by_rates::A, by_rates::at_shoulder>, torque<by_rates::A, -by_rates::at_elbow>,
                torque<by_rates::B, by_rates::at_elbow>>> {};

// The energies of bodies, as expressions in velocities.
constexpr auto v1 = velocity_of<by_rates::G1>;
constexpr auto v2 = velocity_of<by_rates::G2>;
constexpr auto by_velocities = (m1 * dot(v1, v1) + m2 * dot(v2, v2) + I1 * w1 * w1 + I2 * w2 * w2) / 2;

struct FromVelocities
    : lagrange_system<
          inertial<N>, coordinates<q1, q2>, lagrangian<by_velocities - potential>,
          parameters<m1, m2, d1, d2, l1, I1, I2, g, c1, c2>, inputs<T1, T2>,
          loads<torque<by_rates::A, by_rates::at_shoulder>, torque<by_rates::A, -by_rates::at_elbow>,
                torque<by_rates::B, by_rates::at_elbow>>> {};

} // namespace twofold

template <class One, class Other>
void are_equal(const check::numbers& values) {
  using one = equations_of_motion<One>;
  using other = equations_of_motion<Other>;
  const auto p = check::parameters_by_name<One>(values);
  const auto same = check::parameters_by_name<Other>(values);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const auto x = one::state::NullaryExpr([&] { return any(random); }).eval();
    const auto r = one::inputs::NullaryExpr([&] { return any(random); }).eval();
    EXPECT_TRUE(oracle::close(one::mass_matrix(x, p, r), other::mass_matrix(x, same, r), 1e-13));
    EXPECT_TRUE(oracle::close(one::forcing(x, p, r), other::forcing(x, same, r), 1e-13));
    EXPECT_TRUE(oracle::close(one::udot(x, p, r), other::udot(x, same, r), 1e-12));
  }
}

TEST(lagrangian, by_hand_gives_the_same) {
  are_equal<simple_pendulum::LagrangeSystem, simple::ByHand>(numbers_of("simple_pendulum"));
  are_equal<double_pendulum::LagrangeSystem, twofold::ByHand>(numbers_of("double_pendulum"));
  are_equal<double_pendulum::LagrangeSystem, twofold::FromVelocities>(numbers_of("double_pendulum"));
}

} // namespace
