// builds: clang++ all
// A motor with an elastic shaft under a PI controller: its eigenvalues, and where its energy goes.
#include <kanexpr/simulate.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <models/elastic_drive.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

namespace {

using namespace elastic_drive;

constexpr state_variable<"supplied"> supplied;
constexpr state_variable<"lost"> lost;

/// The drive with two meters: the energy that the voltage and the brake supply, and that which becomes heat.
struct Metered
    : kane_system<inertial<Ground>, joints<Rotor, Disk>, blocks<Controller>, states<supplied, lost>,
                  dynamics<dot(supplied) == Controller::output * current_of<Rotor> - T * u_of<Disk>,
                           dot(lost) == R * current_of<Rotor> * current_of<Rotor> +
                                            c*(u_of<Rotor> - u_of<Disk>)*(u_of<Rotor> - u_of<Disk>)>,
                  parameters<J1, J2, k, c, R, L, kt, kp, ki, V, Tt>, inputs<reference, T>,
                  loads<dc_motor<Rotor, Controller::output, R, L, kt>, torque<Disk, -T * Ground::x>,
                        torsional_spring<q_of<Disk> - q_of<Rotor>, k>, torsional_damper<Disk, Rotor, c>>> {};

kanexpr::parameter_values<System> numbers() {
  return {{J1, 4e-4}, {J2, 1.6e-3}, {k, 0.5},  {c, 2e-3}, {R, 1.2}, {L, 1.2e-3},
          {kt, 0.08}, {kp, 0.25},   {ki, 1.2}, {V, 12},   {Tt, 0.2}};
}

/// With the twist, both speeds, the current and the integral part as states, written by hand. The angle of
/// the disk adds an eigenvalue of zero.
TEST(elastic_drive, has_the_eigenvalues_of_its_equations) {
  const double rotor = 4e-4, disk = 1.6e-3, stiffness = 0.5, damping = 2e-3, inductance = 1.2e-3;
  Eigen::Matrix<double, 6, 6> by_hand = Eigen::Matrix<double, 6, 6>::Zero();
  by_hand.row(0) << 0, 1, -1, 0, 0, 0;
  by_hand.row(1) << Eigen::RowVector4d(-stiffness, -damping, damping, 0.08) / rotor, 0, 0;
  by_hand.row(2) << Eigen::RowVector3d(stiffness, damping, -damping) / disk, 0, 0, 0;
  by_hand.row(3) << Eigen::RowVector<double, 5>(0, -0.08, -0.25, -1.2, 1) / inductance, 0;
  by_hand(4, 2) = -1.2; // the integral part
  by_hand(5, 2) = 1;    // the angle of the disk
  const auto [A, B] =
      linearization<System>::explicit_form(state<System>{}, numbers(), input_values<System>(0, 0));
  const auto sorted = [](const Eigen::Matrix<double, 6, 6>& m) {
    Eigen::Vector<std::complex<double>, 6> all = m.eigenvalues();
    const auto by_parts = [](std::complex<double> s) { return std::pair(s.real(), s.imag()); };
    std::ranges::sort(all.data(), all.data() + all.size(), {}, by_parts);
    return all;
  };
  EXPECT_LT((sorted(A) - sorted(by_hand)).cwiseAbs().maxCoeff(), 1e-9);
}

/// What the voltage and the brake supply is stored or becomes heat.
TEST(elastic_drive, keeps_account_of_its_energy) {
  simulation_options<Metered> how{
      .relative_tolerance = 1e-11, .absolute_tolerance = 1e-13, .output_every = 0.1};
  how.inputs = [](double t, const state<Metered>&, input_values<Metered>& r) {
    r[reference] = 6 * std::tanh(t / 0.05);
    r[T] = 0.1 + 0.05 * std::sin(20 * t);
  };
  const auto run =
      simulate<Metered>(state<Metered>::Zero(), parameter_values<Metered>(numbers()), {0, 2}, how);
  ASSERT_TRUE(run) << run.cause();
  const auto mechanical = run.trajectory.energies().total;
  double most = 0;
  for (std::size_t i = 0; i < mechanical.size(); ++i) {
    const auto& x = run.trajectory[i].x;
    const double magnetic = 1.2e-3 * x[current_of<Rotor>] * x[current_of<Rotor>] / 2;
    EXPECT_NEAR(mechanical[i] + magnetic, x[supplied] - x[lost], 1e-9);
    most = std::max(most, x[supplied]);
  }
  EXPECT_GT(most, 0.1); // J
}

} // namespace
