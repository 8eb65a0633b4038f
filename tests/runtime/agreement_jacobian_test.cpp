// The derivatives of ẋ and the forces of all speeds: compiled and interpreted results agree to the last bit.
#include "models/four_bar.hpp"
#include "runtime/agreement.hpp"

namespace {

using kanexpr::mechanics::quantity;
using eom = kanexpr::equations_of_motion<four_bar::System>;

TEST(agreement, jacobian_of_four_bar) {
  auto derived = kanexpr::derive<four_bar::System>();
  ASSERT_EQ(derived.mistake(), "");
  constexpr kanexpr::function<four_bar::System, quantity::state_jacobian> by_state{};
  constexpr kanexpr::function<four_bar::System, quantity::input_jacobian> by_inputs{};
  auto interpreted_by_state = derived.function(derived.get(quantity::state_jacobian));
  auto interpreted_by_inputs = derived.function(derived.get(quantity::input_jacobian));
  auto forces = derived.function(derived.get(quantity::unreduced_forces));
  std::mt19937_64 source(7);
  for (int round = 0; round < 50; ++round) {
    const auto x = agreement::random<eom::state>(source, -3, 3);
    const auto p = agreement::random<eom::parameters>(source, 0.5, 2);
    const auto r = agreement::random<eom::inputs>(source, -5, 5);
    const auto a = agreement::random<Eigen::Vector3d>(source, -5, 5);
    agreement::expect_same_bits(by_state(x, p, r), interpreted_by_state(x, p, r));
    agreement::expect_same_bits(by_inputs(x, p, r), interpreted_by_inputs(x, p, r));
    agreement::expect_same_bits(eom::unreduced_forces(x, p, r, a), forces(0, x, p, r, a));
  }
}

} // namespace
