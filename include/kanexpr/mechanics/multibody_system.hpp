#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/given_constraints.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::mechanics {

/// The numbers of parts of each kind, the first ones, whose quantities are in SI units by definition, for
/// example because they come from a file of a robot. Their units are not checked, so that their numbers may
/// be factors.
struct parts_in_si_units {
  int frames = 0;
  int points = 0;
  int bodies = 0;
  int kinematics = 0;
  sequence<int> loads{}; ///< by kind, in the order of `loads::each_kind`; empty if there are none

  constexpr int loads_of_kind(int kind) const { return loads.empty() ? 0 : loads[kind]; }
};

/// A mechanical system as plain values: the result of reading a model written as types or of building one at
/// run time, and the input of the derivation.
struct multibody_system {
  mechanics::mechanism mechanism;             ///< coordinates, speeds, frames, points and bodies
  mechanics::loads loads{};                   ///< forces, torques and energies
  mechanics::given_constraints constraints{}; ///< equations that restrict the motion
  parts_in_si_units in_si_units{};

  constexpr explicit multibody_system(graph& owner) : mechanism(owner) {}
  explicit multibody_system(const multibody_system&) = default; // uses the same graph
  multibody_system& operator=(const multibody_system&) = delete;

  /// Declares that the quantities of all present parts are in SI units by definition.
  constexpr void trust_units_of_present_parts() {
    in_si_units = {mechanism.frames.size(),
                   mechanism.points.size(),
                   mechanism.bodies.size(),
                   mechanism.kinematics.size(),
                   {}};
    loads.each_kind([&](const auto& all) { in_si_units.loads.push(all.size()); });
  }

  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.mechanism, self.loads, self.constraints, self.in_si_units);
  }
};

} // namespace kanexpr::mechanics
