#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/numbers/nearby_fraction.hpp>

/// Euler-Bernoulli beams. A particle of the axis of a beam is at x a before the deformation, from the root.
/// With bending v and w in two directions b and c across the axis, and extension s,
///
///     r = (x + s − ½ ∫₀ˣ (v'² + w'²)) a + v b + w c.
///
/// The integral is the foreshortening of a beam whose length does not change as it bends, to second order. The
/// rotary inertia of bending and the deformation by shear are neglected. Torsion turns the sections about a;
/// their polar inertia counts about the undeformed axis. Kane, Ryan & Banerjee (1987), J. Guidance 10(2).
namespace kanexpr::mechanics {

using numeric::beams::deformation;

/// A beam, with the dimensionless integrals over its shapes.
struct beam {
  base::name called{};
  int frame = -1; ///< the frame relative to which it deforms
  int root = -1;  ///< the point at x = 0 of the undeformed axis
  components axis{};
  components across[2]{}; ///< the directions of bending, perpendicular to the axis and to each other
  expression length{};
  expression mass_per_length{};
  expression polar_inertia{}; ///< of the mass, per length
  expression stiffness[4]{};  ///< by deformation: EI, EI, GJ, EA
  base::sequence<deformation> deformations{}; ///< by amplitude
  base::sequence<expression> amplitudes{};
  numeric::beams::modal_integrals integrals{};
};

/// Forms the expressions of a beam from its integrals.
class beam_expressions {
public:
  constexpr explicit beam_expressions(const beam& of) : b_(of), g_(of.length.owner()) {
    mass_ = b_.mass_per_length * b_.length;
  }

  constexpr flexible_body body() const {
    flexible_body f;
    f.called = b_.called;
    f.frame = b_.frame;
    f.reference = b_.root;
    f.amplitudes = b_.amplitudes;
    f.mass = times(b_.integrals.mass(), mass_);
    f.first_moment = first_moment();
    f.inertia = inertia();
    for (int k = 0; k < size(); ++k) f.angular.push(angular(k));
    f.modal_mass = modal_mass();
    return f;
  }

  /// ∫ ∂r/∂q_k · ∂r/∂q_l dm, and the polar inertia of torsion.
  constexpr symbolic::matrix modal_mass() const {
    symbolic::matrix m(g_, size(), size());
    for (int k = 0; k < size(); ++k)
      for (int l = 0; l < size(); ++l)
        if (b_.deformations[k] == b_.deformations[l])
          m(k, l) = times(b_.integrals.product(k, l), inertia_of(k));
    return m;
  }

  /// ∫ EI φ''_k φ''_l dx, ∫ GJ φ'_k φ'_l dx or ∫ EA φ'_k φ'_l dx.
  constexpr symbolic::matrix stiffness() const {
    symbolic::matrix m(g_, size(), size());
    const expression length = b_.length, cube = length * length * length;
    for (int k = 0; k < size(); ++k)
      for (int l = 0; l < size(); ++l) {
        const deformation what = b_.deformations[k];
        if (what != b_.deformations[l] || is_zero(b_.integrals.stiffness(k, l))) continue;
        m(k, l) = times(b_.integrals.stiffness(k, l), b_.stiffness[static_cast<int>(what)]) /
                  (numeric::beams::is_bending(what) ? cube : length);
      }
    return m;
  }

private:
  constexpr int size() const { return b_.amplitudes.size(); }
  static constexpr bool is_zero(double value) { return value * value <= 0; }

  /// A number times an expression.
  constexpr expression times(double number, expression e) const {
    if (is_zero(number)) return {g_, symbolic::graph::zero};
    return symbolic::constant(g_, symbolic::nearby_fraction(number)) * e;
  }
  constexpr expression zero() const { return {g_, symbolic::graph::zero}; }

  /// The mass or the polar inertia that moves with shape k.
  constexpr expression inertia_of(int k) const {
    return b_.deformations[k] == deformation::torsion ? b_.polar_inertia * b_.length : mass_;
  }

  /// The direction in which shape k displaces the axis; torsion does not displace it.
  constexpr const components& direction(int k) const {
    switch (b_.deformations[k]) {
    case deformation::first_bending: return b_.across[0];
    case deformation::second_bending: return b_.across[1];
    case deformation::torsion:
    case deformation::extension: break;
    }
    return b_.axis;
  }
  constexpr bool displaces(int k) const { return b_.deformations[k] != deformation::torsion; }

  /// Σ c_k q_k over the amplitudes of one deformation, with numbers c_k.
  template <class Number>
  constexpr expression linear(deformation what, Number c) const {
    expression sum = zero();
    for (int k = 0; k < size(); ++k)
      if (b_.deformations[k] == what) sum += times(c(k), b_.amplitudes[k]);
    return sum;
  }
  /// Σ c_kl q_k q_l over the amplitudes of two deformations.
  template <class Number>
  constexpr expression quadratic(deformation one, deformation other, Number c) const {
    expression sum = zero();
    for (int k = 0; k < size(); ++k) {
      if (b_.deformations[k] != one) continue;
      sum += b_.amplitudes[k] * linear(other, [&](int l) { return c(k, l); });
    }
    return sum;
  }
  /// ½ Σ c_kl q_k q_l over the amplitudes of bending.
  template <class Number>
  constexpr expression half_of_bending(Number c) const {
    expression sum = zero();
    for (const deformation d : {deformation::first_bending, deformation::second_bending})
      sum += quadratic(d, d, c);
    return sum / 2;
  }

  constexpr components first_moment() const {
    const numeric::beams::modal_integrals& of = b_.integrals;
    const auto zeroth = [&](int k) { return of.zeroth(k); };
    // ∫ x dm + ∫ s dm − ½ ∫ (∫ v'² + w'²) dm; the last one has no factor L
    const expression shortening = half_of_bending([&](int k, int l) { return of.shortening(k, l); });
    const expression along = times(of.first_moment(), mass_ * b_.length) +
                             mass_ * linear(deformation::extension, zeroth) -
                             b_.mass_per_length * shortening;
    const expression in_first = mass_ * linear(deformation::first_bending, zeroth);
    const expression in_second = mass_ * linear(deformation::second_bending, zeroth);
    return sum_of(along, in_first, in_second);
  }

  constexpr components sum_of(expression along, expression in_first, expression in_second) const {
    components v = along * b_.axis;
    if (!in_first.is_zero()) v += in_first * b_.across[0];
    if (!in_second.is_zero()) v += in_second * b_.across[1];
    return v;
  }

  /// ∫ (r·r E − r r) dm to the second order, from the second moments along the axis and across it.
  constexpr symmetric inertia() const {
    constexpr deformation bends[2]{deformation::first_bending, deformation::second_bending};
    const numeric::beams::modal_integrals& of = b_.integrals;
    const auto first = [&](int k) { return of.first(k); };
    const auto product = [&](int k, int l) { return of.product(k, l); };
    const expression stretched = times(of.second_moment(), mass_ * (b_.length * b_.length)) +
                                 2 * (mass_ * b_.length) * linear(deformation::extension, first) +
                                 mass_ * quadratic(deformation::extension, deformation::extension, product);
    const expression shortening = half_of_bending([&](int k, int l) { return of.shortening_moment(k, l); });
    const expression along = stretched - 2 * mass_ * shortening;
    expression with_axis[2], across[2];
    for (int i = 0; i < 2; ++i) {
      with_axis[i] = (mass_ * b_.length) * linear(bends[i], first) +
                     mass_ * quadratic(deformation::extension, bends[i], product);
      across[i] = mass_ * quadratic(bends[i], bends[i], product);
    }
    const expression both = mass_ * quadratic(bends[0], bends[1], product);
    const expression all = along + across[0] + across[1];
    symmetric j(g_);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k <= i; ++k) {
        expression moment = product_of(b_.axis, b_.axis, i, k) * along;
        for (int n = 0; n < 2; ++n) {
          if (!across[n].is_zero()) moment += product_of(b_.across[n], b_.across[n], i, k) * across[n];
          if (!with_axis[n].is_zero()) moment += mixed(b_.axis, b_.across[n], i, k) * with_axis[n];
        }
        if (!both.is_zero()) moment += mixed(b_.across[0], b_.across[1], i, k) * both;
        j(i, k) = (i == k ? all : zero()) - moment;
        if (has_torsion()) j(i, k) += product_of(b_.axis, b_.axis, i, k) * polar();
      }
    return j;
  }
  static constexpr expression product_of(const components& a, const components& b, int i, int k) {
    return a[i] * b[k];
  }
  static constexpr expression mixed(const components& a, const components& b, int i, int k) {
    return a[i] * b[k] + a[k] * b[i];
  }
  constexpr bool has_torsion() const { return b_.deformations.contains(deformation::torsion); }
  constexpr expression polar() const { return times(b_.integrals.polar(), b_.polar_inertia * b_.length); }

  /// ∫ r × ∂r/∂q_k dm to the first order; the foreshortening of r and of its derivative contributes only
  /// terms of higher order.
  constexpr components angular(int k) const {
    const numeric::beams::modal_integrals& of = b_.integrals;
    if (!displaces(k)) return times(of.zeroth(k), inertia_of(k)) * b_.axis;
    const auto product = [&](int l) { return of.product(k, l); };
    const components& d = direction(k);
    components h(g_);
    const auto add = [&](const components& arm, expression moment) {
      if (!moment.is_zero()) h += moment * cross(arm, d);
    };
    if (b_.deformations[k] != deformation::extension)
      add(b_.axis, times(of.first(k), mass_ * b_.length) + mass_ * linear(deformation::extension, product));
    if (b_.deformations[k] != deformation::first_bending)
      add(b_.across[0], mass_ * linear(deformation::first_bending, product));
    if (b_.deformations[k] != deformation::second_bending)
      add(b_.across[1], mass_ * linear(deformation::second_bending, product));
    return h;
  }

  const beam& b_;
  symbolic::graph& g_;
  expression mass_{};
};

} // namespace kanexpr::mechanics
