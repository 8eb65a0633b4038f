// A system that depends explicitly on time: a bead on a rod that rotates at a given rate, pushed along the
// rod.
#include <kanexpr/kanexpr.hpp>

#include <gtest/gtest.h>

namespace bead {

using namespace kanexpr;

constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
constexpr parameter<"m"> m;
constexpr parameter<"w"> w;
constexpr input<"F"> F;
constexpr time_variable t;

struct N : inertial_frame<N> {};
struct Rod : rotated<Rod, N, w * t * t, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, s * Rod::x> {};
struct Bead : particle<Bead, P, m> {};
struct System : kane_system<inertial<N>, coordinates<s>, speeds<v>, kinematics<dot(s) == v>, parameters<m, w>,
                            bodies<Bead>, loads<force<P, F * N::x>>> {};

} // namespace bead

TEST(time, bead_on_a_turning_rod) {
  using eom = kanexpr::equations_of_motion<bead::System>;
  const double t = 0.7, m = 2, w = 1.5, s = 0.8, v = -0.3, force = 4;
  const eom::state x(s, v);
  const eom::parameters p(m, w);
  const eom::inputs r = eom::inputs::Constant(force);
  const double turning = 2 * w * t; // of the rod
  // m (s̈ − s θ̇²) = F cos θ
  EXPECT_NEAR(eom::udot(t, x, p, r)(0), s * turning * turning + force / m * std::cos(w * t * t), 1e-14);
  EXPECT_NEAR(eom::kinetic_energy(t, x, p, r), m * (v * v + s * s * turning * turning) / 2, 1e-14);
  const Eigen::Vector3d a =
      kanexpr::function<bead::System, kanexpr::in_axes_of<bead::Rod>(kanexpr::acceleration_of<bead::P>)>{}(
          t, x, p, r);
  EXPECT_NEAR(a(1), s * 2 * w + 2 * v * turning, 1e-14); // the Euler and Coriolis terms
}
