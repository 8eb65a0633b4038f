#include "models/double_pendulum.hpp"
#include "models/simple_pendulum.hpp"
#include "pendulums_by_hand.hpp"

/// The pendulums derived by kanexpr beside hand-written code, as functions of the same plain arguments;
/// `count` counts their instructions.
extern "C" {

void simple_pendulum_derived(const double* x, const double* p, const double* r, double* rate) {
  using eom = kanexpr::equations_of_motion<simple_pendulum::System>;
  Eigen::Map<Eigen::Vector2d>{rate} =
      eom::rhs(Eigen::Map<const Eigen::Vector2d>(x), Eigen::Map<const Eigen::Vector4d>(p),
               Eigen::Map<const Eigen::Matrix<double, 1, 1>>(r));
}

void simple_pendulum_by_hand(const double* x, const double* p, const double* r, double* rate) {
  simple_pendulum_rhs_by_hand(x, p, r, rate);
}

void double_pendulum_derived(const double* x, const double* p, const double* r, double* rate) {
  using eom = kanexpr::equations_of_motion<double_pendulum::System>;
  Eigen::Map<Eigen::Vector4d>{rate} =
      eom::rhs(Eigen::Map<const Eigen::Vector4d>(x), Eigen::Map<const Eigen::Matrix<double, 10, 1>>(p),
               Eigen::Map<const Eigen::Vector2d>(r));
}

void double_pendulum_by_hand(const double* x, const double* p, const double* r, double* rate) {
  double_pendulum_rhs_by_hand(x, p, r, rate);
}
}
