// builds: g++
// The derivatives of the complete right-hand side with respect to the whole state, for constraints that
// contain time, inputs and acceleration constraints.
#include "compiled/complex_steps.hpp"

namespace hoist {

using namespace kanexpr;

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"vx"> vx;
constexpr speed<"vy"> vy;
constexpr parameter<"m"> m;
constexpr parameter<"c"> c;
constexpr parameter<"g"> g;
constexpr parameter<"k"> k;
constexpr prescribed<"rope"> rope;
constexpr input<"F"> F;
constexpr time_variable t;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x + y * N::y> {};
struct Load : particle<Load, P, m> {};

template <class... Constraints>
struct on_rope : kane_system<inertial<N>, coordinates<x, y>, speeds<vx, vy>,
                             kinematics<dot(x) == vx, dot(y) == vy - sin(t) * x>, bodies<Load>,
                             loads<gravity<-g * N::y>, force<P, F * N::x - c * velocity_of<P>>>,
                             inputs<F, rope, dot(rope), dot(dot(rope))>, Constraints...> {};

constexpr auto apart = x * x + y * y - rope * rope;

/// A load on a rope of prescribed length, and the same load, pulled back to that length.
struct System : on_rope<configuration_constraints<apart == 0>, dependent<y, vy>> {};

constexpr auto rate = 2 * x * vx + 2 * y * (vy - sin(t) * x) - 2 * rope * dot(rope);

struct DrawnBack : on_rope<configuration_constraints<apart == 0>, dependent<y, vy>,
                           acceleration_constraints<derivative(rate) == -2 * k * rate - k * k * apart>> {};

} // namespace hoist

namespace {

using step_checks::point;

template <class System = hoist::System>
point<System> hanging() {
  point<System> at = step_checks::plain_point<System>();
  at.r[hoist::rope] = 2;
  at.x[hoist::y] = -3;
  return at;
}

TEST(jacobian_of_hoist, is_that_of_rhs) { step_checks::jacobian_is_that_of_rhs(hanging()); }
TEST(jacobian_of_hoist, is_that_of_rhs_where_it_is_drawn_back) {
  step_checks::jacobian_is_that_of_rhs(hanging<hoist::DrawnBack>());
}

TEST(jacobian_of_hoist, reduces_to_the_linearization_where_inputs_bind) {
  step_checks::reduces_to_explicit_form(hanging());
}

} // namespace
