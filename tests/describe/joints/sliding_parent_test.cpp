// builds: clang++ sanitize all
// A body attached to a parent that slides without rotating moves with the parent.
#include "describe/joints/newton_euler.hpp"

namespace {

using namespace by_hand;

/// The velocity of a point minus the rate of its position.
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

// Two sliders in a row, one with a home, and a plate welded to the second.
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

// A frame and a point, only the second of which moves.
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

// A joint placed on a cart in ground axes, which do not rotate relative to the cart, is fixed in the cart.
namespace told_from_the_ground {
struct Box : weld<Box, Cart, at<0.7 * Ground::x + 0.1 * Cart::y, 0.2 * own::x>, load> {};
struct Drawer : prismatic<Drawer, Cart, axis<Ground::x - Ground::y>, at<0.2 * Ground::z>, load> {};
struct Lid_at : offset<Lid_at, Cart, 0.4 * Ground::y - 0.3 * Rail::x> {};
struct Lid : pin<Lid, frame_and_point<Cart, Lid_at>, axis<Ground::z>, load> {};
struct System : kane_system<inertial<Ground>, joints<Rail, Cart, Box, Drawer, Lid>, loads<weight>> {};
struct Box_seat : offset<Box_seat, Box, 0.2 * Box::x> {};
struct Cart_seat : offset<Cart_seat, Cart, 0.4 * Cart::x - 0.1 * Cart::y> {};
} // namespace told_from_the_ground

TEST(sliding_parent, carries_what_is_told_in_axes_of_the_ground) {
  using namespace told_from_the_ground;
  const state<System> x = moving<System>();
  const parameter_values<System> p;
  expect_newton_and_euler<System, Box, Box_seat>(Vector3d::Zero(), x, p);
  expect_newton_and_euler<System, Cart, Cart_seat, Box, Drawer, Lid>(Vector3d::Zero(), x, p);
}

// A joint that moves on an arm: its location moves in a circle and keeps its direction in the ground.
namespace seat_moves {
struct Arm : pin<Arm, Ground, axis<own::z>, seat, load> {};
constexpr auto in_a_circle = 0.3 * cos(q_of<Arm>) * Arm::x + (0.1 - 0.3 * sin(q_of<Arm>)) * Arm::y;
struct Link : pin<Link, Arm, axis<Arm::x>, at<in_a_circle, 0.2 * own::x>, load> {};
struct System : kane_system<inertial<Ground>, joints<Arm, Link>, loads<weight>> {};
struct Link_seat : offset<Link_seat, Link, 0.2 * Link::x> {};
} // namespace seat_moves

TEST(reactions, are_those_of_a_seat_that_moves_on_its_parent) {
  using namespace seat_moves;
  expect_newton_and_euler<System, Link, Link_seat>(Vector3d::Zero(), moving<System>(),
                                                   parameter_values<System>());
}

} // namespace
