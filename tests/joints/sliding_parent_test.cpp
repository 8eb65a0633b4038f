// builds: clang++ sanitize
// What hangs on something that slides without turning moves with it.
#include "joints/newton_euler.hpp"

namespace {

using namespace by_hand;

/// The velocity of a point less the rate of its position.
template <class System, class Point>
Vector3d left_over(const state<System>& x) {
  return function<System, velocity_of<Point> - derivative_in<Ground>(position_of<Point, Ground>)>{}(
      x, parameter_values<System>());
}

template <class System>
state<System> moving() {
  state<System> x;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x[i] = 0.3 + 0.19 * static_cast<double>(i * i % 5) - 0.07 * static_cast<double>(i);
  return x;
}

// Two slides in a row, one with a home, and a plate welded on.
struct Rail : prismatic<Rail, Ground, axis<Ground::x>, load> {};
struct Cart : prismatic<Cart, Rail, axis<own::y>, home<0.7, Rail::z>, seat, load> {};
struct Plate : weld<Plate, Cart, at<0.2 * Cart::x>, load> {};

namespace floats {
struct Ship : floating<Ship, Plate, at<0.1 * Plate::y>, angles<"zyx">, load> {};
struct System : kane_system<inertial<Ground>, joints<Rail, Cart, Plate, Ship>, loads<weight>> {};
} // namespace floats

TEST(sliding_parent, carries_what_floats_behind_it) {
  EXPECT_LT((left_over<floats::System, floats::Ship>(moving<floats::System>())).norm(), 1e-14);
}

namespace declared {
constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
struct Skid : offset<Skid, Cart, 0.3 * Cart::x + s * Cart::y>, velocity<Cart, v * Cart::y> {};
struct Load : particle<Load, Skid, 2.0> {};
struct System : kane_system<inertial<Ground>, joints<Rail, Cart>, coordinates<s>, speeds<v>,
                            kinematics<dot(s) == v>, bodies<Load>, loads<weight>> {};
} // namespace declared

TEST(sliding_parent, carries_a_point_with_a_declared_velocity) {
  EXPECT_LT((left_over<declared::System, declared::Skid>(moving<declared::System>())).norm(), 1e-14);
}

// A frame and point of which only the point moves.
namespace on_a_point {
constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
struct Hook : offset<Hook, Ground, s * Ground::y> {};
struct Buoy : floating<Buoy, frame_and_point<Ground, Hook>, angles<"zyx">, load> {};
struct System : kane_system<inertial<Ground>, coordinates<s>, speeds<v>, kinematics<dot(s) == v>,
                            joints<Buoy>, loads<weight, force<Hook, -3 * v * Ground::y>>> {};
} // namespace on_a_point

TEST(moving_point, carries_what_floats_behind_it) {
  EXPECT_LT((left_over<on_a_point::System, on_a_point::Buoy>(moving<on_a_point::System>())).norm(), 1e-14);
}

namespace swings {
struct Load
    : pin<Load, Plate, axis<own::z>, at<0.3 * Plate::x - 0.2 * Plate::y, 0.4 * own::x - 0.1 * own::y>, load> {
};
struct Plain : kane_system<inertial<Ground>, joints<Rail, Cart, Plate, Load>, loads<weight>> {};
struct System : kane_system<inertial<Ground>, joints<Rail, Cart, Plate, Load>, loads<weight>,
                            reactions<Load, Plate, Cart>> {};
struct Seat : offset<Seat, Load, 0.4 * Load::x - 0.1 * Load::y> {};
} // namespace swings

TEST(sliding_parent, is_felt_in_the_reactions_of_what_hangs_on_it) {
  using namespace swings;
  const state<Plain> x = moving<Plain>();
  const parameter_values<Plain> p;
  expect_newton_and_euler<Plain, Load, Seat>(Vector3d::Zero(), x, p);
  expect_newton_and_euler<Plain, Plate, Plate, Load>(Vector3d::Zero(), x, p);
}

TEST(reactions, change_no_motion) {
  using namespace swings;
  const auto plain = equations_of_motion<Plain>::rhs(equations_of_motion<Plain>::state(moving<Plain>()));
  const auto freed = equations_of_motion<System>::rhs(equations_of_motion<System>::state(moving<System>()));
  EXPECT_LT((plain - freed).norm(), 1e-13 * plain.norm());
}

} // namespace
