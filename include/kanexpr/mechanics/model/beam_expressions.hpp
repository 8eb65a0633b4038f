#pragma once

#include <kanexpr/mechanics/model/axial_displacements.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/beam_forms.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
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
/// the beam bends in the natural modes of a free beam, it is measured from the mass center.
///
/// To the second order in the amplitudes and their rates, the kinetic energy contains only the projection of
/// the foreshortening on motions of a rigid axis. With the mass center ξ = c of the straight beam, ξ = x/L,
/// and the mean place p and the mean length e of the bent one, x − ½ ∫₀ˣ (v'² + w'²) becomes p + (ξ − c) e;
/// its rate contributes only with its mean ṗ, in the product with the velocity v_a of the root. The energy
///
///     ½ ∫ (v_a + ω_b w − ω_c v + ṡ + ṗ)² + (v_b + ω_c r_a − ω_a w + v̇)² + (v_c − ω_b r_a + ω_a v + ẇ)² dm
///
/// with r_a = p + (ξ − c) e + s is a sum of squares, and therefore positive for all amplitudes
/// (`definite_inertia`). If v_a does not depend on the generalized speeds, as on a hub that only turns, it is
/// so without ṗ, and the modal mass is constant. If the root is at rest, r_a = ξ e + s with the mean length
/// about the root suffices. Truncated after the second order, the energy becomes negative at amplitudes of a
/// few percent of the length if the base turns and the beam bends in several shapes. With one shape, it is
/// positive far beyond a tenth of the length, so it remains truncated.
///
/// The rotary inertia of bending and the deformation by shear are neglected. Torsion turns the sections about
/// a; their polar inertia counts about the undeformed axis. Kane, Ryan & Banerjee (1987), J. Guidance 10(2).
namespace kanexpr::mechanics {

/// Forms the expressions of a beam from its integrals.
class beam_expressions : beam_forms {
public:
  constexpr explicit beam_expressions(const beam& of) : beam_forms(of) {}

  constexpr flexible_body body() const {
    flexible_body f;
    f.called = b_.called;
    f.frame = b_.frame;
    f.reference = b_.root;
    f.amplitudes = b_.amplitudes;
    f.mass = times(b_.integrals.mass(), mass_);
    f.first_moment = first_moment(along_axis::second_order);
    f.inertia = inertia(along_axis::second_order);
    for (int k = 0; k < size(); ++k) f.angular.push(angular(k, along_axis::second_order));
    f.modal_mass = modal_mass();
    if (bends_in_several_shapes()) f.definite = definite();
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
  /// The contribution of x and of the foreshortening to an integral: to the second order of the kinetic
  /// energy, or omitted.
  enum class along_axis : unsigned char { second_order, omitted };

  constexpr bool bends_in_several_shapes() const {
    int count = 0;
    for (const deformation d : b_.deformations) count += numeric::beams::is_bending(d) ? 1 : 0;
    return count > 1;
  }

  constexpr definite_inertia definite() const {
    definite_inertia d{.first_moment = first_moment(along_axis::omitted),
                       .inertia = inertia(along_axis::omitted),
                       .axis = b_.axis};
    for (int k = 0; k < size(); ++k) d.angular.push(angular(k, along_axis::omitted));
    const axial_displacements of(b_);
    d.about_center = of.about_center();
    d.about_root.push(of.about_root());
    return d;
  }

  /// The mass or the polar inertia that moves with shape k.
  constexpr expression inertia_of(int k) const {
    return b_.deformations[k] == deformation::torsion ? b_.polar_inertia * b_.length : mass_;
  }

  constexpr bool displaces(int k) const { return b_.deformations[k] != deformation::torsion; }

  constexpr components first_moment(along_axis how) const {
    const numeric::beams::modal_integrals& of = b_.integrals;
    const auto zeroth = [&](int k) { return of.zeroth(k); };
    // ∫ x dm + ∫ s dm − ½ ∫ (∫ v'² + w'²) dm; the last one has no factor L
    expression along = zero();
    if (how == along_axis::second_order) along = times(of.first_moment(), mass_ * b_.length);
    along += mass_ * linear(deformation::extension, zeroth);
    if (how == along_axis::second_order)
      along -= b_.mass_per_length * quadratic([&](int k, int l) { return of.shortening(k, l) / 2; });
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

  /// ∫ (r·r E − r r) dm. With r = Σ r_d e_d in the orthonormal directions d of the axis
  /// and of bending, the entry i, k is Σ_d (δ_ik − e_di e_dk) ∫ r_d² dm − Σ_d≠f e_di e_fk ∫ r_d r_f dm.
  constexpr symmetric inertia(along_axis how) const {
    const expression both =
        mass_ * bilinear(deformation::first_bending, deformation::second_bending, products());
    symmetric j(g_);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k <= i; ++k) {
        expression moment = squares(i, k, how);
        for (int n = 0; n < 2; ++n)
          if (const expression e = with_axis(n, how); !e.is_zero())
            moment -= mixed(b_.axis, b_.across[n], i, k) * e;
        if (!both.is_zero()) moment -= mixed(b_.across[0], b_.across[1], i, k) * both;
        if (b_.deformations.contains(deformation::torsion))
          moment += product_of(b_.axis, b_.axis, i, k) * polar();
        j(i, k) = moment;
      }
    return j;
  }

  /// Σ_d (δ_ik − e_di e_dk) ∫ r_d² dm. Directions with the factor 1 share one quadratic form.
  constexpr expression squares(int i, int k, along_axis how) const {
    const components* const directions[3]{&b_.axis, &b_.across[0], &b_.across[1]};
    bool is_shared[3]{};
    expression sum = zero();
    for (int d = 0; d < 3; ++d) {
      const expression product_of_directions = product_of(*directions[d], *directions[d], i, k);
      const expression factor = i == k ? 1 - product_of_directions : -product_of_directions;
      is_shared[d] = factor.is_one();
      if (!is_shared[d] && !factor.is_zero()) {
        const bool only[3]{d == 0, d == 1, d == 2};
        sum += factor * second_moment(only, how);
      }
    }
    return sum + second_moment(is_shared, how);
  }

  /// ∫ r_d² dm, summed over the chosen directions: along the axis, (x + s)² − x ∫ (v'² + w'²) or s²;
  /// across it, v² and w².
  constexpr expression second_moment(const bool (&of)[3], along_axis how) const {
    const numeric::beams::modal_integrals& integrals = b_.integrals;
    const expression form =
        mass_ * quadratic([&](int k, int l) {
          const deformation d = b_.deformations[k];
          if (d == deformation::torsion) return 0.0;
          const int direction = d == deformation::extension ? 0 : d == deformation::first_bending ? 1 : 2;
          const double shortening = of[0] && how == along_axis::second_order && direction != 0
                                        ? integrals.shortening_moment(k, l)
                                        : 0.0;
          return (of[direction] ? integrals.product(k, l) : 0.0) - shortening;
        });
    if (!of[0] || how == along_axis::omitted) return form;
    const expression stretching =
        linear(deformation::extension, [&](int k) { return 2 * integrals.first(k); });
    return times(integrals.second_moment(), mass_ * (b_.length * b_.length)) +
           mass_ * b_.length * stretching + form;
  }

  /// ∫ (x + s) v dm or ∫ (x + s) w dm; without x if its contribution is omitted.
  constexpr expression with_axis(int bending, along_axis how) const {
    const deformation bends = bending == 0 ? deformation::first_bending : deformation::second_bending;
    const expression stretched = mass_ * bilinear(deformation::extension, bends, products());
    if (how == along_axis::omitted) return stretched;
    return (mass_ * b_.length) * linear(bends, [&](int k) { return b_.integrals.first(k); }) + stretched;
  }
  static constexpr expression product_of(const components& a, const components& b, int i, int k) {
    return a[i] * b[k];
  }
  static constexpr expression mixed(const components& a, const components& b, int i, int k) {
    return a[i] * b[k] + a[k] * b[i];
  }
  constexpr expression polar() const { return times(b_.integrals.polar(), b_.polar_inertia * b_.length); }

  /// ∫ r × ∂r/∂q_k dm to the first order, to which the foreshortening of r and of its derivative does not
  /// contribute.
  constexpr components angular(int k, along_axis how) const {
    const numeric::beams::modal_integrals& of = b_.integrals;
    if (!displaces(k)) return times(of.zeroth(k), inertia_of(k)) * b_.axis;
    const auto product = [&](int l) { return of.product(k, l); };
    const components& d = direction(k);
    components h(g_);
    const auto add = [&](const components& arm, expression moment) {
      if (!moment.is_zero()) h += moment * cross(arm, d);
    };
    if (b_.deformations[k] != deformation::extension)
      add(b_.axis, along_moment(k, how) + mass_ * linear(deformation::extension, product));
    if (b_.deformations[k] != deformation::first_bending)
      add(b_.across[0], mass_ * linear(deformation::first_bending, product));
    if (b_.deformations[k] != deformation::second_bending)
      add(b_.across[1], mass_ * linear(deformation::second_bending, product));
    return h;
  }

  /// ∫ x φ_k dm.
  constexpr expression along_moment(int k, along_axis how) const {
    return how == along_axis::omitted ? zero() : times(b_.integrals.first(k), mass_ * b_.length);
  }
};

} // namespace kanexpr::mechanics
