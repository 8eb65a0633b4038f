// builds: clang++ all
// Inverse dynamics, gravity and the Coriolis matrix, compared with M, f, F_r* and energies.
#include "compiled/complex_steps.hpp"

#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/puma.hpp>
#include <models/spinning_top.hpp>

namespace tug {

using namespace kanexpr;

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr coordinate<"q"> q;
constexpr speed<"vx"> vx;
constexpr speed<"vy"> vy;
constexpr speed<"w"> w;
constexpr parameter<"m"> m;
constexpr parameter<"d"> d;
constexpr parameter<"I"> I;
constexpr input<"bow"> bow;
constexpr input<"stern"> stern;
constexpr input<"push"> push;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x + y * N::y> {};
struct Bow : offset<Bow, P, d * A::x> {};
struct Stern : offset<Stern, P, -d * A::x> {};
struct Hull : rigid_body<Hull, P, A, m, inertia<A, 0, 0, I>> {};

/// Thrusters across the hull, and one that pushes north: at q = 0, none of them pushes east.
struct System
    : kane_system<inertial<N>, coordinates<x, y, q>, speeds<vx, vy, w>,
                  kinematics<dot(x) == vx, dot(y) == vy, dot(q) == w>, parameters<m, d, I>,
                  inputs<bow, stern, push>, bodies<Hull>,
                  loads<force<Bow, bow * A::y>, force<Stern, stern * A::y>, force<P, 3 * push * N::y>>> {};

} // namespace tug

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

template <class System, class Check>
void at_random_points(Check check) {
  std::mt19937_64 source(17);
  for (int round = 0; round < 20; ++round)
    check(step_checks::random_point(source, step_checks::plain_point<System>(), 2), source);
}

// The remaining forces are provided by the rest of the model.
template <class System>
void forces_are_those_that_M_and_f_leave() {
  using eom = kanexpr::equations_of_motion<System>;
  at_random_points<System>([](const step_checks::point<System>& at, std::mt19937_64& source) {
    const VectorXd rates = step_checks::random_numbers(source, eom::speeds, 2);
    const Eigen::Matrix<double, eom::speeds, 1> a = rates;
    const VectorXd found = [&] {
      no_heap::guard guard;
      return eom::inverse_dynamics(at.t, at.x, at.p, at.r, a);
    }();
    const VectorXd inertia = eom::mass_matrix(at.t, at.x, at.p) * a,
                   force = eom::forcing(at.t, at.x, at.p, at.r);
    EXPECT_LE((found - (inertia - force)).norm(), 1e-12 * (inertia.norm() + force.norm()));
  });
}
TEST(inverse_dynamics, is_what_the_mass_matrix_and_forcing_leave) {
  forces_are_those_that_M_and_f_leave<double_pendulum::System>();
  forces_are_those_that_M_and_f_leave<iiwa::System>();
  forces_are_those_that_M_and_f_leave<tug::System>();
}

template <class System>
void balance_in_motion() {
  using eom = kanexpr::equations_of_motion<System>;
  at_random_points<System>([](const step_checks::point<System>& at, std::mt19937_64&) {
    const auto rates = eom::udot(at.t, at.x, at.p, at.r);
    const VectorXd found = eom::inverse_dynamics(at.t, at.x, at.p, at.r, rates),
                   forces = eom::active_forces(at.t, at.x, at.p, at.r);
    EXPECT_LE(found.norm(), 1e-11 * (1 + forces.norm() + rates.norm()));
  });
}
TEST(inverse_dynamics, vanishes_in_motion_with_constraints) {
  balance_in_motion<four_bar::System>();
  balance_in_motion<four_bar::LagrangeSystem>();
}

template <class System>
void inputs_bring_about_the_rates() {
  using eom = kanexpr::equations_of_motion<System>;
  at_random_points<System>([](const step_checks::point<System>& at, std::mt19937_64& source) {
    const auto rates = eom::udot(at.t, at.x, at.p, at.r);
    typename eom::inputs others = at.r;
    others += step_checks::random_numbers(source, others.size(), 5);
    const auto found = eom::required_inputs(at.t, at.x, at.p, others, rates);
    EXPECT_TRUE(kanexpr::status_of(found));
    EXPECT_LE((found - at.r).norm(), 1e-10 * (1 + at.r.norm()));
  });
}
TEST(required_inputs, are_those_that_act) {
  inputs_bring_about_the_rates<double_pendulum::System>();
  inputs_bring_about_the_rates<tug::System>();
  inputs_bring_about_the_rates<four_bar::System>();
  inputs_bring_about_the_rates<four_bar::LagrangeSystem>();
}

TEST(required_inputs, need_no_inputs) {
  using eom = kanexpr::equations_of_motion<double_pendulum::System>;
  const step_checks::point<double_pendulum::System> at = step_checks::plain_point<double_pendulum::System>();
  const auto rates = eom::udot(at.x, at.p, at.r);
  EXPECT_EQ(eom::required_inputs(at.x, at.p, {}, rates), eom::required_inputs(at.x, at.p, at.r, rates));
}

TEST(required_inputs, tell_where_they_do_not_act) {
  using eom = kanexpr::equations_of_motion<tug::System>;
  const step_checks::point<tug::System> at = step_checks::plain_point<tug::System>();
  const auto found = eom::required_inputs(at.x, at.p, at.r, Eigen::Vector3d(1, 0, 0));
  EXPECT_FALSE(found.status);
  EXPECT_EQ(found.status.cause(),
            "the equations of motion cannot be solved for inputs bow and stern at this state");
}

template <class System>
void gravity_is_the_slope_of_its_energy() {
  using eom = kanexpr::equations_of_motion<System>;
  at_random_points<System>([](const step_checks::point<System>& at, std::mt19937_64&) {
    const auto energy = [](const auto&... arguments) {
      return Eigen::VectorXcd::Constant(1, eom::potential_energy(arguments...)).eval();
    };
    const VectorXd slope =
        step_checks::derivatives<System>(energy, at).leftCols(eom::coordinates).transpose();
    const VectorXd found = eom::gravity_compensation(at.t, at.x, at.p);
    EXPECT_LE((found - slope).norm(), 1e-12 * (1 + slope.norm()));
  });
}
TEST(gravity_compensation, is_the_slope_of_the_potential_energy) {
  gravity_is_the_slope_of_its_energy<iiwa::System>();
  gravity_is_the_slope_of_its_energy<spinning_top::LagrangeSystem>();
}

template <class System>
void holds_at_rest() {
  using eom = kanexpr::equations_of_motion<System>;
  at_random_points<System>([](step_checks::point<System> at, std::mt19937_64&) {
    at.x.tail(eom::speeds).setZero();
    at.r.setZero();
    const Eigen::Matrix<double, eom::speeds, 1> none = Eigen::Matrix<double, eom::speeds, 1>::Zero();
    const VectorXd found = eom::gravity_compensation(at.x, at.p),
                   held = eom::inverse_dynamics(at.t, at.x, at.p, at.r, none);
    EXPECT_LE((found - held).norm(), 1e-12 * (1 + held.norm()));
  });
}
TEST(gravity_compensation, holds_what_rests) {
  holds_at_rest<double_pendulum::System>();
  holds_at_rest<four_bar::System>();
  holds_at_rest<four_bar::LagrangeSystem>();
  holds_at_rest<puma::System>();
}

template <class System>
void coriolis_is_of_the_inertia_forces() {
  using eom = kanexpr::equations_of_motion<System>;
  constexpr int n = eom::speeds;
  at_random_points<System>([](const step_checks::point<System>& at, std::mt19937_64&) {
    const MatrixXd C = eom::coriolis(at.t, at.x, at.p);
    const VectorXd u = at.x.tail(n);
    const Eigen::Matrix<double, n, 1> none = Eigen::Matrix<double, n, 1>::Zero();
    const VectorXd quadratic = -eom::inertia_forces(at.t, at.x, at.p, at.r, none);
    EXPECT_LE((C * u - quadratic).norm(), 1e-12 * (1 + quadratic.norm()));

    using complex = std::complex<double>;
    kanexpr::state<System, complex> moved(at.x.template cast<complex>());
    const auto velocity = eom::qdot(at.t, at.x, at.p);
    for (int i = 0; i < n; ++i) moved(i) += complex(0, 1e-30 * velocity(i));
    const MatrixXd rate = eom::mass_matrix(at.t, moved, at.p).imag() / 1e-30;
    const MatrixXd skew = rate - 2 * C;
    EXPECT_LE((skew + skew.transpose()).norm(), 1e-12 * (1 + rate.norm()));
  });
}
TEST(coriolis, is_quadratic_in_the_speeds_and_leaves_a_skew_matrix) {
  coriolis_is_of_the_inertia_forces<iiwa::System>();
  coriolis_is_of_the_inertia_forces<spinning_top::LagrangeSystem>();
}

} // namespace
