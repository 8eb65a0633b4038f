#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/element.hpp>
#include <kanexpr/mechanics/loads/force_and_torque.hpp>
#include <kanexpr/mechanics/loads/given_potential_energy.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/modal_damping.hpp>
#include <kanexpr/mechanics/loads/spring_damper.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// A constant of a block or a motor that must be positive, such as a time constant.
struct positive_constant {
  expression value{};
  name of{}; ///< such as "the time constant of block F"

  constexpr void check_with(load_check& by) const { by.check_positive(value, of.view(), {}); }
};

/// The loads on a mechanism, as given. Each load type defines how it acts on a `force_system`, the checks of
/// its expressions and, if it is conservative, its potential energy. `point` and `against`, or `frame` and
/// `against`, are the points or frames on which it acts.
///
/// Only the loads that other code looks into have lists of their own; all others are elements.
struct loads {
  sequence<force> forces{};
  sequence<torque> torques{};
  sequence<spring_damper> spring_dampers{};
  sequence<torsional_damper> torsional_dampers{};
  sequence<given_potential_energy> potential_energies{};
  sequence<modal_damping> modal_dampings{};
  sequence<element> elements{};
  sequence<state_rate> state_rates{};
  sequence<positive_constant> positive_constants{};
  bool has_gravity = false;
  vector gravity{}; ///< free-fall acceleration, applied to every body
  bool has_lagrangian = false;
  expression lagrangian{}; ///< replaces the energies of the bodies

  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.forces, self.torques, self.spring_dampers, self.torsional_dampers, self.potential_energies,
          self.modal_dampings, self.elements, self.state_rates, self.positive_constants, self.has_gravity,
          self.gravity, self.has_lagrangian, self.lagrangian);
  }

  /// Calls `visit` with each list of loads.
  template <class Visit>
  constexpr void each_kind(Visit&& visit) const {
    const auto visit_all = [&](const auto&... kinds) { (visit(kinds), ...); };
    visit_all(forces, torques, spring_dampers, torsional_dampers, potential_energies, modal_dampings,
              elements, state_rates);
  }
  /// Calls `visit` for each load except gravity, with the load and its index in its list.
  template <class Visit>
  constexpr void each(Visit&& visit) const {
    each_kind([&](const auto& all) {
      for (int i = 0; i < all.size(); ++i) visit(all[i], i);
    });
  }

  /// Adds a load that has no list of its own.
  template <class Load>
  constexpr void add(const Load& load) {
    elements.push(element_of(load));
  }
  /// The elements of a kind, in the order in which they were added.
  template <class Load>
  constexpr sequence<Load> all() const {
    sequence<Load> found;
    for (const element& e : elements)
      if (e.kind == &element_kind_of<Load>) found.push(load_in<Load>(e));
    return found;
  }
};

} // namespace kanexpr::mechanics
