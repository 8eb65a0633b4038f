#pragma once

#include <kanexpr/mechanics/constraints/given_constraints.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>

namespace kanexpr::mechanics {

/// A mechanical system as plain values: what models written as types are read into, what programs build while
/// they run, and what equations are derived from.
struct multibody_system {
  mechanics::mechanism mechanism;             ///< what moves
  mechanics::loads loads{};                   ///< what acts
  mechanics::given_constraints constraints{}; ///< what binds

  constexpr explicit multibody_system(graph& owner) : mechanism(owner) {}
  explicit multibody_system(const multibody_system&) = default; // of the same graph
  multibody_system& operator=(const multibody_system&) = delete;
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.mechanism);
    visit(self.loads);
    visit(self.constraints);
  }
};

} // namespace kanexpr::mechanics
