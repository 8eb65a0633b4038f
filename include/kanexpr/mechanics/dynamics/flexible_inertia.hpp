#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/inertia_moment.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/skeleton/flexible_part.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

/// The inertia of flexible bodies relative to a floating frame of reference (Shabana, Dynamics of Multibody
/// Systems, 2020, chapter 5; Wallrapp 1994). The mass m, the first moment S and the inertia J about a point
/// of the frame, H_k = ∫ r × ∂r/∂q_k dm and the constant modal masses M_kl define the kinetic energy
///
///   T = ½ m v·v + v·(ω×S + Ṡ) + ½ ω·J·ω + ω·Σ H_k q̇_k + ½ Σ M_kl q̇_k q̇_l
///
/// with the velocity v of this point; dots denote the rates of components in the frame. S, J and H_k may also
/// contain displacements y(q), with respect to which they are differentiated like another amplitude. With the
/// mass M_yy of a displacement, T also contains ω·H_y ẏ + ½ M_yy ẏ² + Σ M_ky q̇_k ẏ. Everything below follows
/// from this energy without further approximation. Therefore, Kane's and Lagrange's equations agree, and
/// energy and momenta are conserved. All components are in the axes `flexible_part::axes`.
namespace kanexpr::mechanics {

/// A force at the station of a flexible body, a moment on its frame about this station, and the
/// generalized forces of its amplitudes.
struct flexible_load {
  components force{};
  components moment{};
  sequence<expression> on_amplitudes{};
};

namespace detail {

/// Σ q̇_k v_k.
constexpr components by_rates(const flexible_part& p, components flexible_part::amplitude::* v, graph& g) {
  components sum(g);
  for (const flexible_part::amplitude& k : p.amplitudes) sum += k.rate * (k.*v);
  return sum;
}

/// Σ q̇_k v_k for a sequence of vectors.
constexpr components by_rates(const flexible_part& p, const sequence<components>& v, graph& g) {
  components sum(g);
  for (int k = 0; k < v.size(); ++k) sum += p.amplitudes[k].rate * v[k];
  return sum;
}

/// Ṡ.
constexpr components rate_of_first_moment(const flexible_part& p, graph& g) {
  components sum = by_rates(p, &flexible_part::amplitude::translation, g);
  for (const flexible_part::displacement& y : p.displacements) sum += y.rate * y.translation;
  return sum;
}

/// h = Σ H_k q̇_k + H_y ẏ.
constexpr components momentum_of_rates(const flexible_part& p, graph& g) {
  components sum = by_rates(p, &flexible_part::amplitude::rotation, g);
  for (const flexible_part::displacement& y : p.displacements) sum += y.rate * y.rotation;
  return sum;
}

/// Σ ∂v_k/∂q_l q̇_k q̇_l. The antisymmetric part of the derivatives does not contribute.
constexpr components by_products_of_rates(const flexible_part& p,
                                          sequence<components> flexible_part::amplitude::* derivatives,
                                          graph& g) {
  components sum(g);
  for (int k = 0; k < p.amplitudes.size(); ++k)
    for (int l = 0; l <= k; ++l) {
      const flexible_part::amplitude &one = p.amplitudes[k], &other = p.amplitudes[l];
      components both = (one.*derivatives)[l];
      if (l != k) both += (other.*derivatives)[k];
      sum += (one.rate * other.rate) * both;
    }
  return sum;
}

/// J̇.
constexpr symmetric rate_of_inertia(const flexible_part& p, graph& g) {
  symmetric rate(g);
  for (const flexible_part::amplitude& k : p.amplitudes)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) rate(i, j) += k.rate * k.growth(i, j);
  for (const flexible_part::displacement& y : p.displacements) rate = rate + y.rate * y.growth;
  return rate;
}

/// ½ w·A·w.
constexpr expression half_of_quadratic_form(const symmetric& a, const components& w) {
  expression sum = (a.xx / 2) * (w.x * w.x);
  sum += (a.yy / 2) * (w.y * w.y);
  sum += (a.zz / 2) * (w.z * w.z);
  sum += a.xy * (w.x * w.y);
  sum += a.yz * (w.y * w.z);
  sum += a.zx * (w.z * w.x);
  return sum;
}

/// The inertia forces of one flexible body with opposite signs, for a motion with accelerations.
class demand_of_flexible_part {
public:
  constexpr demand_of_flexible_part(motion& k, const flexible_part& p)
      : p_(p), g_(*k.skeleton_used().model->g) {
    const skeleton& s = k.skeleton_used();
    const path to_axes(*s.model, s.working_axes[p.frame], p.axes);
    a_ = to_axes.turn(k.acceleration(p.station, p.frame));
    w_ = to_axes.turn(k.angular_velocity(p.frame));
    alpha_ = to_axes.turn(k.angular_acceleration(p.frame));
    u_ = acceleration_matrix(w_, alpha_);
    for (const flexible_part::amplitude& each : p.amplitudes) second_rates_.push(k.rate(each.rate));
    for (const flexible_part::displacement& y : p.displacements) displacements_.push(driven(y));
  }

  constexpr flexible_load run() const {
    flexible_load demand{.force = force(), .moment = moment()};
    for (int k = 0; k < p_.amplitudes.size(); ++k) demand.on_amplitudes.push(on_amplitude(k));
    return demand;
  }

private:
  using amplitude = flexible_part::amplitude;
  using displacement = flexible_part::displacement;

  /// The motion of a displacement y.
  struct driven_displacement {
    expression acceleration{}; ///< ÿ
    components spin{};         ///< (Σ ∂H_k/∂y q̇_k + Ḣ_y) ẏ
    expression force{};        ///< the demand on y, felt by q_k with the factor ∂y/∂q_k
  };

  /// The force is P_y·a + H_y·α + M_yy ÿ + Σ M_ky q̈_k + ω·(Ḣ_y − Σ ∂H_k/∂y q̇_k) − ½ ω·∂J/∂y·ω.
  constexpr driven_displacement driven(const displacement& y) const {
    driven_displacement d{.acceleration = y.bias};
    for (int l = 0; l < y.gradient.size(); ++l) d.acceleration += y.gradient[l] * second_rates_[l];
    const components by_amplitudes = by_rates(p_, y.rotation_rate, g_),
                     own = by_rates(p_, y.rotation_by_amplitude, g_);
    d.spin = y.rate * (by_amplitudes + own);
    d.force = dot(y.translation, a_);
    d.force += dot(y.rotation, alpha_);
    d.force += y.mass * d.acceleration;
    for (int k = 0; k < y.coupling.size(); ++k) d.force += y.coupling[k] * second_rates_[k];
    d.force += dot(w_, own - by_amplitudes);
    d.force -= half_of_quadratic_form(y.growth, w_);
    return d;
  }

  constexpr components by_second_rates(components amplitude::* v) const {
    components sum(g_);
    for (int k = 0; k < p_.amplitudes.size(); ++k) sum += second_rates_[k] * (p_.amplitudes[k].*v);
    return sum;
  }

  /// m a + U S + 2 ω×Ṡ + S̈.
  constexpr components force() const {
    components f = p_.mass.mass * a_;
    f += u_ * p_.mass.first_moment;
    f += symbolic::constant(g_, symbolic::real(2)) * cross(w_, rate_of_first_moment(p_, g_));
    f += by_second_rates(&amplitude::translation);
    f += by_products_of_rates(p_, &amplitude::translation_rate, g_);
    for (int i = 0; i < displacements_.size(); ++i)
      f += displacements_[i].acceleration * p_.displacements[i].translation;
    return f;
  }

  /// S×a + J·α + ω×(J·ω) + J̇·ω + ω×h + ḣ with h = Σ H_k q̇_k + H_y ẏ.
  constexpr components moment() const {
    components t = cross(p_.mass.first_moment, a_);
    t += inertia_moment(p_.mass.inertia, w_, alpha_, u_);
    t += rate_of_inertia(p_, g_) * w_;
    t += cross(w_, momentum_of_rates(p_, g_));
    t += by_second_rates(&amplitude::rotation);
    t += by_products_of_rates(p_, &amplitude::rotation_rate, g_);
    for (int i = 0; i < displacements_.size(); ++i) {
      t += displacements_[i].acceleration * p_.displacements[i].rotation;
      t += displacements_[i].spin;
    }
    return t;
  }

  /// P_k·a + H_k·α + Σ M_kl q̈_l + M_ky ÿ + ω·Σ (∂H_k/∂q_l − ∂H_l/∂q_k) q̇_l + ω·(∂H_k/∂y − ∂H_y/∂q_k) ẏ
  /// − ½ ω·∂J/∂q_k·ω, and the force on a displacement times ∂y/∂q_k.
  constexpr expression on_amplitude(int k) const {
    const amplitude& own = p_.amplitudes[k];
    expression force = dot(own.translation, a_);
    force += dot(own.rotation, alpha_);
    for (int l = 0; l < p_.amplitudes.size(); ++l) {
      force += p_.modal_mass(k, l) * second_rates_[l];
      if (l < k)
        force += gyroscopic(k, l) * p_.amplitudes[l].rate;
      else if (l > k)
        force -= gyroscopic(l, k) * p_.amplitudes[l].rate;
    }
    for (int i = 0; i < displacements_.size(); ++i) {
      const displacement& y = p_.displacements[i];
      force += y.coupling[k] * displacements_[i].acceleration;
      force += dot(w_, y.rotation_rate[k] - y.rotation_by_amplitude[k]) * y.rate;
      force += y.gradient[k] * displacements_[i].force;
    }
    force -= half_of_quadratic_form(own.growth, w_);
    return force;
  }

  /// ω·(∂H_k/∂q_l − ∂H_l/∂q_k).
  constexpr expression gyroscopic(int k, int l) const {
    return dot(w_, p_.amplitudes[k].rotation_rate[l] - p_.amplitudes[l].rotation_rate[k]);
  }

  const flexible_part& p_;
  graph& g_;
  components a_{}, w_{}, alpha_{};
  matrix3 u_{};
  sequence<expression> second_rates_{};
  sequence<driven_displacement> displacements_{};
};

} // namespace detail

/// The inertia forces of a flexible body, with opposite signs.
constexpr flexible_load inertia_demand(motion& k, const flexible_part& p) {
  return detail::demand_of_flexible_part(k, p).run();
}

/// The weight of a flexible body for the free-fall acceleration `gravity`.
constexpr flexible_load weight(const flexible_part& p, const components& gravity) {
  flexible_load load{.force = p.mass.mass * gravity, .moment = cross(p.mass.first_moment, gravity)};
  for (int k = 0; k < p.amplitudes.size(); ++k) load.on_amplitudes.push(dot(p.total_translation(k), gravity));
  return load;
}

/// The momentum of a flexible body: linear, and angular about its station.
struct flexible_momentum {
  components linear{};
  components angular{};
};

/// m v + ω×S + Ṡ and S×v + J·ω + h.
constexpr flexible_momentum momentum(motion& k, const flexible_part& p) {
  const skeleton& s = k.skeleton_used();
  const path to_axes(*s.model, s.working_axes[p.frame], p.axes);
  const components v = to_axes.turn(k.velocity(p.station, p.frame)),
                   w = to_axes.turn(k.angular_velocity(p.frame));
  flexible_momentum total{.linear = p.mass.mass * v, .angular = cross(p.mass.first_moment, v)};
  total.linear += cross(w, p.mass.first_moment);
  total.linear += detail::rate_of_first_moment(p, *s.model->g);
  total.angular += p.mass.inertia * w;
  total.angular += detail::momentum_of_rates(p, *s.model->g);
  return total;
}

/// 2 T.
constexpr expression twice_kinetic_energy(motion& k, const flexible_part& p) {
  const skeleton& s = k.skeleton_used();
  const path to_axes(*s.model, s.working_axes[p.frame], p.axes);
  const components v = to_axes.turn(k.velocity(p.station, p.frame)),
                   w = to_axes.turn(k.angular_velocity(p.frame));
  components moving = cross(w, p.mass.first_moment);
  moving += detail::rate_of_first_moment(p, *s.model->g);
  expression twice = p.mass.mass * dot(v, v);
  twice += 2 * dot(v, moving);
  twice += dot(w, p.mass.inertia * w);
  twice += 2 * dot(w, detail::momentum_of_rates(p, *s.model->g));
  for (int i = 0; i < p.amplitudes.size(); ++i)
    for (int j = 0; j <= i; ++j) {
      const expression rates = p.amplitudes[i].rate * p.amplitudes[j].rate;
      twice += (i == j ? p.modal_mass(i, j) : 2 * p.modal_mass(i, j)) * rates;
    }
  for (const flexible_part::displacement& y : p.displacements) {
    twice += y.mass * (y.rate * y.rate);
    for (int i = 0; i < p.amplitudes.size(); ++i)
      twice += 2 * y.coupling[i] * (p.amplitudes[i].rate * y.rate);
  }
  return twice;
}

} // namespace kanexpr::mechanics
