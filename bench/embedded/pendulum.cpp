#include "models/simple_pendulum.hpp"

/// The right side of the pendulum for a controller without an operating system, in single precision; the
/// arguments are plain arrays in the order of the model's vectors.
extern "C" void pendulum(const float* x, const float* p, const float* r, float* rate) {
  using eom = kanexpr::equations_of_motion<simple_pendulum::System>;
  Eigen::Map<Eigen::Vector2f>{rate} =
      eom::rhs(Eigen::Map<const Eigen::Vector2f>(x), Eigen::Map<const Eigen::Vector4f>(p),
               Eigen::Map<const Eigen::Matrix<float, 1, 1>>(r));
}
