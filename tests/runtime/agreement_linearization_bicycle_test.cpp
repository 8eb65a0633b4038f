// builds: g++
#include "models/bicycle.hpp"
#include "runtime/agreement.hpp"

namespace {

using lin = kanexpr::linearization<bicycle::System>;

constexpr kanexpr::symbolic::cost cost = lin::cost(lin::explicit_form);
static_assert(cost.multiplications + cost.additions <= 3509);

TEST(agreement, linearization_of_bicycle) {
  using kanexpr::mechanics::quantity;
  auto derived = kanexpr::derive<bicycle::System>();
  auto A = derived.function(derived.get(quantity::state_matrix));
  std::mt19937_64 source(7);
  for (int round = 0; round < 50; ++round) {
    const auto x = agreement::random<lin::state>(source, -3, 3);
    const auto p = agreement::random<lin::parameters>(source, 0.5, 2);
    const auto [a, b] = lin::explicit_form(x, p);
    agreement::expect_same_bits(a, A(x, p));
    EXPECT_EQ(b.cols(), 0);
  }
}

} // namespace
