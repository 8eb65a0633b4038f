#pragma once

#include <kanexpr/mechanics/check.hpp>
#include <kanexpr/mechanics/energy.hpp>
#include <kanexpr/mechanics/kane.hpp>
#include <kanexpr/symbolic/cost.hpp>

namespace kanexpr::mechanics {

/// What can be asked of a system. Each is a matrix of expressions; n is the number of coordinates, p of
/// speeds.
enum class quantity {
  mass_matrix,      ///< M, p×p
  forcing,          ///< f with M u̇ = f, p
  mass_matrix_full, ///< blockdiag(E, M), (n+p)×(n+p)
  forcing_full,     ///< [q̇; f], n+p
  qdot,             ///< n
  udot,             ///< p
  rhs,              ///< [q̇; u̇], n+p
  active_forces,    ///< F_r, p
  inertia_forces,   ///< F_r*, p, with the symbols u̇
  kinetic_energy,
  potential_energy, ///< of gravity on every body
  linear_momentum,  ///< 3, inertial axes
  angular_momentum, ///< 3, inertial axes, about the origin
  center_of_mass,   ///< 3, inertial axes, from the origin
};

/// The equations of one system. Nothing is formed before it is asked for, and nothing twice.
class equations {
public:
  constexpr explicit equations(const mechanism& m) : s_(skeleton_of(m)), m_(&m) {}
  equations(const equations&) = delete;
  equations& operator=(const equations&) = delete;

  constexpr const skeleton& skeleton_used() const { return s_; }

  /// A mistake that only the derivation could find.
  constexpr const problem& mistake() const { return mistake_; }

  constexpr symbolic::matrix get(quantity wanted) {
    const int n = m_->coordinates.size(), p = m_->speeds.size();
    switch (wanted) {
    case quantity::mass_matrix: return mass();
    case quantity::forcing: return column(force());
    case quantity::mass_matrix_full: {
      symbolic::matrix full(*m_->g, n + p, n + p);
      for (int i = 0; i < n; ++i) full(i, i) = m_->one();
      for (int i = 0; i < p; ++i)
        for (int j = 0; j < p; ++j) full(n + i, n + j) = mass()(i, j);
      return full;
    }
    case quantity::forcing_full: return column(s_.coordinate_rates, force());
    case quantity::qdot: return column(s_.coordinate_rates);
    case quantity::udot: return column(accelerations());
    case quantity::rhs: return column(s_.coordinate_rates, accelerations());
    case quantity::active_forces: return column(mechanics::active_forces(s_));
    case quantity::inertia_forces: return column(mechanics::inertia_forces(s_));
    case quantity::kinetic_energy: return column({mechanics::kinetic_energy(moving())});
    case quantity::potential_energy: return column({mechanics::potential_energy(s_)});
    case quantity::linear_momentum: return column(mechanics::linear_momentum(moving()));
    case quantity::angular_momentum: return column(mechanics::angular_momentum(moving()));
    case quantity::center_of_mass: return column(mechanics::center_of_mass(s_));
    }
    return {};
  }

  /// An expression with the rates q̇ and u̇ as the equations of motion give them.
  constexpr expression in_motion(expression e) {
    e = known_rates(*m_, s_.coordinate_rates).in(e);
    if (!holds_speed_rate(e.node())) return e;
    symbolic::substitution accelerated(*m_->g);
    for (int i = 0; i < m_->speeds.size(); ++i) accelerated.replace(m_->speed_rates[i], accelerations()[i]);
    return accelerated.in(e);
  }

  /// Velocities and accelerations as they are, with the symbols u̇.
  constexpr motion& moving() {
    if (!has_motion_) motion_ = motion(s_, speed_rates::as_symbols);
    has_motion_ = true;
    return motion_;
  }

private:
  constexpr bool holds_speed_rate(int output) const {
    const sequence<char> live = symbolic::live_nodes(*m_->g, {output});
    for (const expression& rate : m_->speed_rates)
      if (live[rate.node()] != 0) return true;
    return false;
  }

  constexpr const symbolic::matrix& mass() {
    if (mass_.rows == 0) {
      mass_ = mechanics::mass_matrix(s_);
      mistake_ = check_mass_matrix(*m_, mass_);
    }
    return mass_;
  }
  constexpr const sequence<expression>& force() {
    if (force_.empty()) force_ = mechanics::forcing(s_);
    return force_;
  }
  constexpr const sequence<expression>& accelerations() {
    if (udot_.empty()) udot_ = symbolic::solve_symmetric(*m_->g, mass(), force());
    return udot_;
  }

  constexpr symbolic::matrix column(const sequence<expression>& above,
                                    const sequence<expression>& below = {}) const {
    symbolic::matrix m(*m_->g, above.size() + below.size(), 1);
    for (int i = 0; i < above.size(); ++i) m.entries[i] = above[i];
    for (int i = 0; i < below.size(); ++i) m.entries[above.size() + i] = below[i];
    return m;
  }
  constexpr symbolic::matrix column(const components& v) const {
    return column(sequence<expression>{v.x, v.y, v.z});
  }

  skeleton s_;
  const mechanism* m_;
  problem mistake_;
  symbolic::matrix mass_;
  sequence<expression> force_, udot_;
  bool has_motion_ = false;
  motion motion_;
};

} // namespace kanexpr::mechanics
