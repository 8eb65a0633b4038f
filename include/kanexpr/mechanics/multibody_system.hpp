#pragma once

#include <kanexpr/mechanics/constraints/given_constraints.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::mechanics {

/// A mechanical system as plain values: the result of reading a model written as types or of building one at
/// run time, and the input of the derivation.
struct multibody_system {
  mechanics::mechanism mechanism;             ///< coordinates, speeds, frames, points and bodies
  mechanics::loads loads{};                   ///< forces, torques and energies
  mechanics::given_constraints constraints{}; ///< equations that restrict the motion

  constexpr explicit multibody_system(graph& owner) : mechanism(owner) {}
  explicit multibody_system(const multibody_system&) = default; // uses the same graph
  multibody_system& operator=(const multibody_system&) = delete;
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.mechanism, self.loads, self.constraints);
  }
};

} // namespace kanexpr::mechanics
