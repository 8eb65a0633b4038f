// builds: clang++
// Axes of any length: only their directions matter.
#include "describe/joints/by_hand.hpp"

namespace {

using namespace by_hand;

constexpr parameter<"long"> length;

using ball = body<2, 0.3 * own::x + 0.1 * own::y, inertia<own, 1, 2, 2.5>>;

/// The unit vectors themselves, multiples of them, and a length that is passed to each call.
enum class scale { one, number, symbol };
template <scale by, class Direction>
constexpr auto scaled(const Direction& unit) {
  if constexpr (by == scale::one)
    return unit;
  else if constexpr (by == scale::number)
    return 2.5 * unit;
  else
    return length * unit;
}
template <scale by>
using oblique = axis<scaled<by>(0.6 * own::x + 0.8 * own::z)>;
template <scale by>
using two = axis<scaled<by>(0.6 * own::x + 0.8 * own::y), scaled<by>(0.8 * own::x - 0.6 * own::z)>;
template <scale by>
using turned = home<0.3, scaled<by>(0.8 * Ground::x + 0.6 * Ground::y)>;

template <scale by>
struct Pin : pin<Pin<by>, Ground, oblique<by>, turned<by>, ball> {};
template <scale by>
struct Slide : prismatic<Slide<by>, Ground, oblique<by>, turned<by>, ball> {};
template <scale by>
struct Sleeve : cylindrical<Sleeve<by>, Ground, oblique<by>, ball> {};
template <scale by>
struct Nut : screw<Nut<by>, Ground, oblique<by>, pitch<0.2>, ball> {};
template <scale by>
struct Cross : universal<Cross<by>, Ground, two<by>, ball> {};
template <scale by>
struct Puck : planar<Puck<by>, Ground, two<by>, ball> {};
template <scale by>
struct Basis : pin<Basis<by>, Ground, axis<scaled<by>(own::y)>, ball> {};

template <scale by>
struct All : kane_system<inertial<Ground>,
                         joints<Pin<by>, Slide<by>, Sleeve<by>, Nut<by>, Cross<by>, Puck<by>, Basis<by>>,
                         parameters<length>, used_elsewhere<length>, // by some
                         loads<weight, motor<Pin<by>, 1.3>, motor<Slide<by>, -0.7>, motor<Nut<by>, 0.4>,
                               motor<Basis<by>, 0.9>, joint_friction<Pin<by>, 0.2>>> {};

template <scale by>
auto accelerations(double long_as) {
  using eom = equations_of_motion<All<by>>;
  typename eom::state x;
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = 0.4 + 0.17 * static_cast<double>(i * i % 7);
  return Eigen::VectorXd(eom::udot(x, typename eom::parameters(long_as)));
}

TEST(axes, have_any_length) {
  const Eigen::VectorXd unit = accelerations<scale::one>(1), numbers = accelerations<scale::number>(1);
  for (Eigen::Index i = 0; i < unit.size(); ++i) {
    EXPECT_NEAR(numbers[i], unit[i], 1e-12 * (1 + std::abs(unit[i]))) << i;
    for (const double of : {0.3, 7.0})
      EXPECT_NEAR(accelerations<scale::symbol>(of)[i], unit[i], 1e-12 * (1 + std::abs(unit[i]))) << i;
  }
}

} // namespace
