#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/energy.hpp>
#include <kanexpr/mechanics/dynamics/gathered.hpp>
#include <kanexpr/mechanics/dynamics/generalized_force.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

/// Lagrange's equations d/dt ∂L/∂q̇ − ∂L/∂q = Q as M q̈ = f, without constraints (Goldstein, Classical
/// Mechanics, 2002, sections 1.4, 2.4). The speeds of the mechanism are the rates q̇.
namespace kanexpr::mechanics {

/// The momenta p = ∂L/∂q̇ and the derivatives ∂L/∂q of a Lagrangian, computed by one reverse pass.
struct lagrangian_gradient {
  sequence<expression> momenta{};
  sequence<expression> by_coordinates{};
};

constexpr lagrangian_gradient gradient_of(const mechanism& m, expression lagrangian) {
  symbolic::accumulation back(*m.g, {lagrangian});
  back.seed(lagrangian, m.one());
  back.run();
  lagrangian_gradient out;
  for (const expression& u : m.speeds) out.momenta.push(back.by(u));
  for (const expression& q : m.coordinates) out.by_coordinates.push(back.by(q));
  out.by_coordinates.resize(m.speeds.size(), m.zero()); // state variables have no coordinate
  return out;
}

class lagrange_equations {
public:
  constexpr lagrange_equations(const skeleton& s, const loads& acting)
      : s_(s), m_(*s.model), loads_(acting) {}

  /// The stored members.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.gradient_);
  }

  /// M = ∂p/∂q̇; symmetric.
  constexpr symbolic::matrix mass_matrix() {
    const sequence<expression>& p = gradient().momenta;
    symbolic::matrix mass(*m_.g, p.size(), p.size());
    symbolic::differentiation by_rate(*m_.g);
    for (int j = 0; j < p.size(); ++j) {
      by_rate.restart();
      by_rate.set_rate(m_.speeds[j], m_.one());
      for (int i = 0; i <= j; ++i) mass(i, j) = mass(j, i) = by_rate.of(p[i]);
    }
    for (int i = m_.speeds_of_motion(); i < mass.rows; ++i) mass(i, i) = m_.one();
    return mass;
  }

  /// Q + ∂L/∂q − ṗ, where Q contains the loads that are not in L; f at q̈ = 0 if no rates are given.
  constexpr sequence<expression> forcing(const sequence<expression>& udot = {}) {
    const sequence<expression> of_loads = forces_of_loads();
    return sum(of_loads, inertia_forces(udot));
  }

  /// ∂L/∂q − ṗ for given rates of the speeds.
  constexpr sequence<expression> inertia_forces(const sequence<expression>& udot) {
    return inertia_of(gradient(), udot);
  }

  /// Q, the generalized forces of the loads that are not in L.
  constexpr sequence<expression> forces_of_loads() const {
    generalized_forces f(s_);
    f.add_loads(loads_, false, conservative::by_energy);
    return f.run();
  }

  /// Q − ∂V/∂q, the generalized forces of all loads.
  constexpr sequence<expression> active_forces() const {
    const sequence<expression> of_loads = forces_of_loads();
    return sum(of_loads, gradient_of(m_, -potential_energy(s_, loads_)).by_coordinates);
  }

  /// −(d/dt ∂/∂q̇ − ∂/∂q) at q̈ = 0 of the kinetic energy, or of the Lagrangian given by the model.
  constexpr sequence<expression> inertia_bias() const { return inertia_of(gradient_of(m_, kinetic()), {}); }

private:
  constexpr expression kinetic() const {
    if (loads_.has_lagrangian) return loads_.lagrangian;
    motion k(s_);
    return kinetic_energy(k);
  }

  constexpr const lagrangian_gradient& gradient() {
    if (!gradient_.momenta.empty()) return gradient_;
    const expression of_motion = kinetic(), of_place = potential_energy(s_, loads_);
    sequence<expression> energies{of_motion, of_place};
    if (has_sines_in_components(m_, loads_)) energies = gathered(*m_.g, energies);
    return gradient_ = gradient_of(m_, energies[0] - energies[1]);
  }

  constexpr sequence<expression> inertia_of(const lagrangian_gradient& l,
                                            const sequence<expression>& udot) const {
    symbolic::differentiation along_time = time_derivative(m_, m_.speeds, udot);
    sequence<expression> bias = l.by_coordinates;
    for (int i = 0; i < bias.size(); ++i) bias[i] -= along_time.of(l.momenta[i]);
    for (int i = m_.speeds_of_motion(); i < udot.size(); ++i) bias[i] -= udot[i];
    return bias;
  }

  static constexpr sequence<expression> sum(sequence<expression> a, const sequence<expression>& b) {
    for (int i = 0; i < a.size(); ++i) a[i] += b[i];
    return a;
  }

  const skeleton& s_;
  const mechanism& m_;
  const loads& loads_;
  lagrangian_gradient gradient_{};
};

} // namespace kanexpr::mechanics
