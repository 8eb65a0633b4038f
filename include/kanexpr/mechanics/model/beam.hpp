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
/// The integral is the foreshortening of a beam whose length does not change as it bends, to second order. If
/// the beam bends in the natural modes of a free beam, its frame moves freely, and the foreshortening is
/// measured from the mass center: the axial motion that results at the root would otherwise make the kinetic
/// energy, which is truncated, indefinite for amplitudes of a few percent of the length.
/// The rotary inertia of bending and the deformation by shear are neglected. Torsion turns the sections about
/// a; their polar inertia counts about the undeformed axis. Kane, Ryan & Banerjee (1987), J. Guidance 10(2).
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
  expression polar_inertia{};                 ///< of the mass, per length
  expression stiffness[4]{};                  ///< by deformation: EI, EI, GJ, EA
  base::sequence<deformation> deformations{}; ///< by amplitude
  base::sequence<expression> amplitudes{};
  numeric::beams::modal_integrals integrals{};
  base::sequence<double> sections{}; ///< the numbers of an outline; empty if it is not drawn
};

constexpr beam_outline outline_of(const beam& b) {
  if (b.sections.empty()) return {};
  return {b.axis, {b.across[0], b.across[1]}, b.length, b.deformations, b.sections};
}

/// The beam whose outline a flexible body has, without its mass and stiffness.
constexpr beam outlined_beam(const flexible_body& f) {
  beam b;
  b.called = f.called;
  b.frame = f.frame;
  b.root = f.reference;
  b.axis = f.outline.axis;
  for (int i = 0; i < 2; ++i) b.across[i] = f.outline.across[i];
  b.length = b.mass_per_length = f.outline.length;
  b.deformations = f.outline.deformations;
  b.amplitudes = f.amplitudes;
  return b;
}

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
    f.outline = outline_of(b_);
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

  /// The position of a section from the root.
  constexpr components place(const numeric::beams::section_values& at) const {
    const auto value = [&](int k) { return at.value(k); };
    const expression shortening = quadratic([&](int k, int l) { return at.shortening(k, l) / 2; });
    const expression stretched = times(at.xi(), b_.length) + linear(deformation::extension, value);
    return sum_of(shortening.is_zero() ? stretched : stretched - shortening / b_.length,
                  linear(deformation::first_bending, value), linear(deformation::second_bending, value));
  }

  /// The angle by which a deformation rotates a section, to the second order: the slope of bending, v'(1 −
  /// s') with the extension s, or the angle about the axis. Without torsion, a section that is rotated by v'
  /// and then by w' must also be rotated about the axis by −∫ v'' w' dx, if the axis, v and w are
  /// right-handed.
  constexpr expression angle(const numeric::beams::section_values& at, deformation what) const {
    if (what == deformation::torsion) {
      const expression twist = bilinear(deformation::first_bending, deformation::second_bending,
                                        [&](int k, int l) { return at.twist(k, l); });
      const expression torsion = linear(what, [&](int k) { return at.value(k); });
      if (twist.is_zero()) return torsion;
      const expression hand = dot(b_.axis, cross(b_.across[0], b_.across[1]));
      return torsion - hand * twist / (b_.length * b_.length);
    }
    const expression slope = linear(what, [&](int k) { return at.slope(k); }) / b_.length;
    const expression stretched =
        bilinear(what, deformation::extension, [&](int k, int l) { return at.slope(k) * at.slope(l); });
    return stretched.is_zero() ? slope : slope - stretched / (b_.length * b_.length);
  }
  /// Whether a deformation rotates sections; bending in two directions also twists them.
  constexpr bool rotates(deformation what) const {
    const base::sequence<deformation>& all = b_.deformations;
    const bool is_bent_twice =
        all.contains(deformation::first_bending) && all.contains(deformation::second_bending);
    return what != deformation::extension &&
           (all.contains(what) || (what == deformation::torsion && is_bent_twice));
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
  constexpr expression bilinear(deformation one, deformation other, Number c) const {
    expression sum = zero();
    for (int k = 0; k < size(); ++k)
      for (int l = 0; l < size(); ++l)
        if (b_.deformations[k] == one && b_.deformations[l] == other)
          sum += times(c(k, l), b_.amplitudes[k] * b_.amplitudes[l]);
    return sum;
  }
  /// Σ c_kl q_k q_l over pairs of amplitudes of the same deformation, with a symmetric c.
  template <class Number>
  constexpr expression quadratic(Number c) const {
    expression sum = zero();
    for (int k = 0; k < size(); ++k)
      for (int l = 0; l <= k; ++l)
        if (b_.deformations[k] == b_.deformations[l])
          sum += times(k == l ? c(k, k) : 2 * c(k, l), b_.amplitudes[l] * b_.amplitudes[k]);
    return sum;
  }

  constexpr components first_moment() const {
    const numeric::beams::modal_integrals& of = b_.integrals;
    const auto zeroth = [&](int k) { return of.zeroth(k); };
    // ∫ x dm + ∫ s dm − ½ ∫ (∫ v'² + w'²) dm; the last one has no factor L
    const expression shortening = quadratic([&](int k, int l) { return of.shortening(k, l) / 2; });
    const expression along = times(of.first_moment(), mass_ * b_.length) +
                             mass_ * linear(deformation::extension, zeroth) - b_.mass_per_length * shortening;
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

  constexpr auto products() const {
    return [this](int k, int l) { return b_.integrals.product(k, l); };
  }

  /// ∫ (r·r E − r r) dm to the second order. With r = Σ r_d e_d in the orthonormal directions d of the axis
  /// and of bending, the entry i, k is Σ_d (δ_ik − e_di e_dk) ∫ r_d² dm − Σ_d≠f e_di e_fk ∫ r_d r_f dm.
  constexpr symmetric inertia() const {
    const expression both =
        mass_ * bilinear(deformation::first_bending, deformation::second_bending, products());
    symmetric j(g_);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k <= i; ++k) {
        expression moment = squares(i, k);
        for (int n = 0; n < 2; ++n)
          if (const expression e = with_axis(n); !e.is_zero())
            moment -= mixed(b_.axis, b_.across[n], i, k) * e;
        if (!both.is_zero()) moment -= mixed(b_.across[0], b_.across[1], i, k) * both;
        if (b_.deformations.contains(deformation::torsion))
          moment += product_of(b_.axis, b_.axis, i, k) * polar();
        j(i, k) = moment;
      }
    return j;
  }

  /// Σ_d (δ_ik − e_di e_dk) ∫ r_d² dm. Directions with the factor 1 share one quadratic form.
  constexpr expression squares(int i, int k) const {
    const components* const directions[3]{&b_.axis, &b_.across[0], &b_.across[1]};
    bool is_shared[3]{};
    expression sum = zero();
    for (int d = 0; d < 3; ++d) {
      const expression product_of_directions = product_of(*directions[d], *directions[d], i, k);
      const expression factor = i == k ? 1 - product_of_directions : -product_of_directions;
      is_shared[d] = factor.is_one();
      if (!is_shared[d] && !factor.is_zero()) {
        const bool only[3]{d == 0, d == 1, d == 2};
        sum += factor * second_moment(only);
      }
    }
    return sum + second_moment(is_shared);
  }

  /// ∫ r_d² dm, summed over the chosen directions: along the axis, (x + s)² − x ∫ (v'² + w'²), and v² and w².
  constexpr expression second_moment(const bool (&of)[3]) const {
    const numeric::beams::modal_integrals& integrals = b_.integrals;
    const expression form =
        mass_ * quadratic([&](int k, int l) {
          const deformation d = b_.deformations[k];
          if (d == deformation::torsion) return 0.0;
          const int direction = d == deformation::extension ? 0 : d == deformation::first_bending ? 1 : 2;
          const double shortening = of[0] && direction != 0 ? integrals.shortening_moment(k, l) : 0.0;
          return (of[direction] ? integrals.product(k, l) : 0.0) - shortening;
        });
    if (!of[0]) return form;
    const expression stretching =
        linear(deformation::extension, [&](int k) { return 2 * integrals.first(k); });
    return times(integrals.second_moment(), mass_ * (b_.length * b_.length)) +
           mass_ * b_.length * stretching + form;
  }

  /// ∫ (x + s) v dm or ∫ (x + s) w dm.
  constexpr expression with_axis(int bending) const {
    const deformation bends = bending == 0 ? deformation::first_bending : deformation::second_bending;
    return (mass_ * b_.length) * linear(bends, [&](int k) { return b_.integrals.first(k); }) +
           mass_ * bilinear(deformation::extension, bends, products());
  }
  static constexpr expression product_of(const components& a, const components& b, int i, int k) {
    return a[i] * b[k];
  }
  static constexpr expression mixed(const components& a, const components& b, int i, int k) {
    return a[i] * b[k] + a[k] * b[i];
  }
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
