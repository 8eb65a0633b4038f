// Compiled and interpreted linearizations agree to the last bit.
#include "models/four_bar.hpp"
#include "models/rotating_tube.hpp"
#include "no_heap.hpp"
#include "runtime/agreement.hpp"

namespace {

using kanexpr::mechanics::quantity;

template <class Function, class... Arguments>
auto without_heap(Function function, const Arguments&... arguments) {
  no_heap::guard guard;
  return function(arguments...);
}

// Several results in one column: shared linear systems are expanded in the form that is cheapest for all.
template <class Model>
kanexpr::symbolic::matrix column(Model& derived, std::initializer_list<quantity> wanted) {
  kanexpr::symbolic::matrix all(derived.graph(), 0, 1);
  for (const quantity each : wanted)
    for (const auto& entry : derived.get(each).entries) all.entries.push(entry);
  all.rows = all.entries.size();
  return all;
}

template <class... Matrices>
Eigen::VectorXd column(const Matrices&... matrices) {
  Eigen::VectorXd all((matrices.size() + ...));
  Eigen::Index next = 0;
  const auto add = [&](const auto& m) {
    for (Eigen::Index i = 0; i < m.rows(); ++i)
      for (Eigen::Index j = 0; j < m.cols(); ++j) all(next++) = m(i, j);
  };
  (add(matrices), ...);
  return all;
}

template <class System>
void check() {
  using lin = kanexpr::linearization<System>;
  auto derived = kanexpr::derive<System>();
  ASSERT_EQ(derived.mistake(), "");
  auto in_states = derived.function(column(derived, {quantity::state_matrix, quantity::input_matrix}));
  auto in_full =
      derived.function(column(derived, {quantity::implicit_mass_matrix, quantity::implicit_state_matrix,
                                        quantity::implicit_input_matrix}));
  auto udot = derived.function(derived.udot());
  auto used = kanexpr::derive<System>();
  for (const quantity each : {quantity::udot, quantity::kinetic_energy, quantity::multipliers,
                              quantity::implicit_mass_matrix, quantity::state_jacobian})
    used.get(each);
  used.linearize().implicit_form();
  auto after_others = used.function(column(used, {quantity::state_matrix, quantity::input_matrix}));
  std::mt19937_64 source(7);
  for (int round = 0; round < 50; ++round) {
    const auto x = agreement::random<typename lin::state>(source, -3, 3);
    const auto p = agreement::random<typename lin::parameters>(source, 0.5, 2);
    const auto r = agreement::random<typename lin::inputs>(source, -5, 5);
    const auto [a, b] = without_heap(lin::explicit_form, x, p, r);
    agreement::expect_same_bits(column(a, b), in_states(x, p, r));
    EXPECT_LT((column(a, b) - after_others(x, p, r)).norm(), 1e-12 * column(a, b).norm());
    const auto [m, a_full, b_full] = without_heap(lin::implicit_form, x, p, r);
    agreement::expect_same_bits(column(m, a_full, b_full), in_full(x, p, r));
    const Eigen::VectorXd rates = udot(x, p, r);
    const auto [given_a, given_b] = without_heap(lin::explicit_form_at, x, p, r, rates);
    EXPECT_LE((column(given_a, given_b) - column(a, b)).norm(), 1e-12 * a.norm());
  }
}

TEST(agreement, linearization_of_four_bar) { check<four_bar::System>(); }
TEST(agreement, linearization_of_rotating_tube) { check<rotating_tube::System>(); }

} // namespace
