#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/consistent_configurations.hpp>
#include <kanexpr/mechanics/constraints/constraints.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Configuration constraints that follow from the others only where all of them hold, such as the closure
/// equations of a loop with special geometry. In other configurations they are independent and seem to leave
/// no motion.
namespace kanexpr::mechanics {

/// The redundant constraints at configurations where all constraints hold.
struct repeated_constraints {
  bool is_known = false;  ///< true if such a configuration was found
  sequence<int> places{}; ///< the constraints that follow from the preceding ones there
};

constexpr repeated_constraints find_repeated(const mechanism& m, const symbolic::matrix& by_q,
                                             const sequence<expression>& all) {
  constexpr double nothing = 1e-6;
  repeated_constraints found;
  consistent_configurations states(m, by_q, all);
  sequence<char> repeats(all.size(), 1);
  int looked = 0;
  for (int attempts = 0; attempts < 12 && looked < 2; ++attempts) {
    if (!states.next()) continue;
    ++looked;
    row_space before(nothing);
    for (int i = 0; i < states.count_of_norms() + all.size(); ++i) {
      sequence<double> row = states.row(i);
      double square = 0;
      for (double e : row) square += e * e;
      const bool adds = square > nothing * nothing && before.add(row);
      if (adds && i >= states.count_of_norms()) repeats[i - states.count_of_norms()] = 0;
    }
  }
  found.is_known = looked > 0;
  for (int i = 0; i < all.size() && found.is_known; ++i)
    if (repeats[i] != 0) found.places.push(i);
  return found;
}

/// Returns advice for constraints that seem to leave no motion: "; where all hold, configuration constraint 5
/// follows from the preceding ones; add redundant<5> to drop it". Empty if they do leave none.
constexpr sentence advice_on_redundant(const mechanism& m, const symbolic::matrix& by_q,
                                       const constraints& c) {
  if (c.on_configuration.size() < 2) return {};
  const repeated_constraints found = find_repeated(m, by_q, c.on_configuration);
  if (!found.is_known)
    return sentence({"; list configuration constraints that follow from others in redundant<...>"});
  const int count = found.places.size();
  if (count == 0 || c.on_configuration.size() - count >= m.coordinates.size()) return {};
  sequence<int> numbers;
  for (const int place : found.places) numbers.push(c.numbers[place]);
  return sentence(
      {"; where all hold, ",
       dropping(numbers, " follows from the preceding ones", " follow from the preceding ones").view()});
}

} // namespace kanexpr::mechanics
