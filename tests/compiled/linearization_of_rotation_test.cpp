// builds: clang++
// A linearization whose kinematic equations contain more than coordinate rates.
#include "compiled/complex_steps.hpp"
#include "steps/quaternions.hpp"

namespace {

using namespace quaternions;

struct Turning : kane_system<inertial<N>, coordinates<e0, e1, e2, e3>, speeds<u1, u2, u3>,
                             kinematics<kinematics_of<A, N>>, bodies<Upper>, loads<gravity<-9.81 * N::z>>> {};

TEST(linearization, of_a_rotation_is_that_of_complex_steps) {
  std::mt19937_64 source(5);
  for (int i = 0; i < 10; ++i) {
    const auto at = step_checks::random_point<Turning>(source, step_checks::plain_point<Turning>(), 1);
    const auto [A, B] = linearization<Turning>::explicit_form(at.x, at.p, at.r);
    const Eigen::MatrixXd expected = step_checks::derivatives<Turning>(equations_of_motion<Turning>::rhs, at);
    EXPECT_LE((A - expected).norm(), 1e-12 * expected.norm());
  }
}

} // namespace
