#pragma once

#include <kanexpr/reactions.hpp>

#include <gtest/gtest.h>

/// A body attached to the ground by a joint, and the equivalent system written by hand.
namespace by_hand {

using namespace kanexpr;

struct Ground : inertial_ground<Ground> {};

using seat = at<0.3 * Ground::x - 0.2 * Ground::y + 0.1 * Ground::z, 0.4 * own::x - 0.1 * own::y>;
using load =
    body<2.5, 0.05 * own::x + 0.2 * own::y - 0.1 * own::z, inertia<own, 0.4, 0.5, 0.6, 0.01, -0.02, 0.03>>;

/// The same location and load written by hand, with a frame `Child` and a point `Joint` in it.
template <class Child>
constexpr auto from_joint = -(0.4 * Child::x - 0.1 * Child::y);
template <class Child>
constexpr auto center_of = 0.05 * Child::x + 0.2 * Child::y - 0.1 * Child::z;

template <class Self, class Center, class Child>
using load_of = rigid_body<Self, Center, Child, 2.5, inertia<Child, 0.4, 0.5, 0.6, 0.01, -0.02, 0.03>>;

using weight = gravity<1.2 * Ground::x + 0.7 * Ground::y - 9.81 * Ground::z>;

/// Whether two systems with states in the same order have the same rates up to rounding.
template <class System, class Hand>
void expect_same_motion() {
  using eom = equations_of_motion<System>;
  using hand = equations_of_motion<Hand>;
  typename eom::state x;
  typename hand::state y;
  ASSERT_EQ(x.size(), y.size());
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x[i] = y[i] = 0.4 + 0.17 * static_cast<double>(i * i % 7) - 0.09 * static_cast<double>(i);
  const auto rhs = eom::rhs(x), expected = hand::rhs(y);
  ASSERT_EQ(rhs.size(), expected.size());
  for (Eigen::Index i = 0; i < rhs.size(); ++i)
    EXPECT_NEAR(rhs[i], expected[i], 1e-13 * (1 + std::abs(expected[i]))) << i;
  constexpr auto cost = eom::cost(eom::rhs), cost_by_hand = hand::cost(hand::rhs);
  EXPECT_EQ(cost.multiplications, cost_by_hand.multiplications);
  EXPECT_EQ(cost.additions, cost_by_hand.additions);
}

} // namespace by_hand
