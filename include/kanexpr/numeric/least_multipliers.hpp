#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/numeric/constrained_motion.hpp>
#include <kanexpr/numeric/independence.hpp>
#include <kanexpr/numeric/typical_magnitudes.hpp>

#include <Eigen/Core>
#include <string>
#include <utility>

namespace kanexpr {

namespace numeric {

/// u̇ and λ in M u̇ = f + Jᵀ λ with J u̇ + γ = 0, where rows of J may be linearly dependent. λ has the least
/// sum of squares among all multipliers that give the same forces.
template <class Speeds, class Multipliers>
struct least_multipliers {
  Speeds udot{};
  Multipliers multipliers{};  ///< those of the velocity constraints, then those of the redundant ones
  independence constraints{}; ///< the constraints that depend on others at the state
  base::sentence failure{};

  explicit operator bool() const { return !failure; }
  /// Returns the cause of a failure as a sentence; empty on success.
  std::string cause() const { return failure.cause(); }
};

/// Finds u̇ and λ at a state; `of` provides the equations in the form that `constrained_motion` requires.
/// Rows of redundant constraints follow the first `solved` rows of J.
template <class Equations>
auto find_least_multipliers(const Equations& of, const typename constrained_motion<Equations>::state& x,
                            int solved) {
  using motion = constrained_motion<Equations>;
  constexpr double least = sizeof(typename Equations::number) < sizeof(double) ? 4e-5 : 1e-9;
  least_multipliers<typename motion::speeds, typename motion::rows_of_speeds> found;
  found.udot.setZero(of.speeds());
  found.multipliers.setZero(of.rows_of_speeds());
  const auto rank_of = [&](const auto& rows) -> Eigen::Index {
    found.constraints = independence_of(rows.template cast<double>(), solved, least);
    return found.constraints.rank;
  };
  const status s =
      motion(of, typical_magnitudes(of, x), x).find_at(x, rank_of, found.udot, found.multipliers);
  if (!s) found.failure = base::sentence({s.view()});
  return found;
}

} // namespace numeric

} // namespace kanexpr
