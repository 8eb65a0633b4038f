#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/beam_forms.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// The projections of the place x − ½ ∫₀ˣ (v'² + w'²) along the axis of a beam on motions of a rigid axis.
class axial_displacements : beam_forms {
  // clang requires that templates used by constant expressions be defined before the functions that use them

  /// ψ = constant + slope ξ, with ξ = x/L.
  struct line {
    double constant = 0, slope = 0;
  };
  /// The integral of ψ times a function from the integrals of the function and of ξ times the function; 0 if
  /// it vanishes except for rounding.
  static constexpr double integral(const line& of, double zeroth, double first) {
    const double linear = of.slope * first, value = of.constant * zeroth + linear;
    return value * value <= 1e-28 * linear * linear ? 0.0 : value;
  }

  /// x − ½ Σ c_kl q_k q_l / L for the unbent place x and foreshortening in bending.
  template <class Number>
  constexpr expression shortened(expression x, Number by) const {
    const expression sum = quadratic(
        [&](int k, int l) { return numeric::beams::is_bending(b_.deformations[k]) ? by(k, l) / 2 : 0.0; });
    return sum.is_zero() ? x : x - sum / b_.length;
  }

  /// An entry of E − a a.
  constexpr expression across(int i, int k) const {
    const expression along = b_.axis[i] * b_.axis[k];
    return i == k ? 1 - along : -along;
  }

  /// ∫ ψ (2 s (E − a a) − v (a b + b a) − w (a c + c a)) dm from the numbers ∫ ψ φ_k.
  template <class Number>
  constexpr symmetric inertia(Number with) const {
    const expression stretched = (2 * mass_) * linear(deformation::extension, with);
    const expression bent[2]{mass_ * linear(deformation::first_bending, with),
                             mass_ * linear(deformation::second_bending, with)};
    symmetric j(g_);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k <= i; ++k) {
        expression moment = across(i, k) * stretched;
        for (int n = 0; n < 2; ++n)
          if (!bent[n].is_zero())
            moment -= (b_.axis[i] * b_.across[n][k] + b_.axis[k] * b_.across[n][i]) * bent[n];
        j(i, k) = moment;
      }
    return j;
  }

public:
  constexpr explicit axial_displacements(const beam& of) : beam_forms(of) {}

  /// p + (ξ − c) e with the mass center ξ = c of the straight beam: the mean place p and the mean length e.
  constexpr base::sequence<axial_displacement> about_center() const {
    const double center = b_.integrals.first_moment() / b_.integrals.mass();
    return {displacement({1, 0}, center), displacement({-center, 1}, 1)};
  }
  /// ξ e with the mean length e about the root. It enters only the moments about the root: the first moment
  /// remains that of the foreshortened beam.
  constexpr axial_displacement about_root() const {
    axial_displacement y = displacement({0, 1}, 1);
    y.first_moment = components(g_);
    return y;
  }

private:
  /// The displacement y ψ, where y = straight·L if the beam is not bent.
  constexpr axial_displacement displacement(const line& by, double straight) const {
    const numeric::beams::modal_integrals& of = b_.integrals;
    const double first = integral(by, of.first_moment(), of.second_moment()),
                 zeroth = integral(by, of.mass(), of.first_moment()), square = integral(by, zeroth, first);
    axial_displacement y;
    y.value = shortened(times(straight, b_.length), [&](int k, int l) {
      return integral(by, of.shortening(k, l), of.shortening_moment(k, l)) / square;
    });
    y.first_moment = times(zeroth, mass_) * b_.axis;
    const auto with = [&](int k) { return integral(by, of.zeroth(k), of.first(k)); };
    y.inertia = inertia(with);
    y.squared = symmetric(g_);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k <= i; ++k) y.squared(i, k) = across(i, k) * times(square, mass_);
    for (int k = 0; k < size(); ++k) {
      const deformation d = b_.deformations[k];
      y.angular.push(numeric::beams::is_bending(d) ? times(with(k), mass_) * cross(b_.axis, direction(k))
                                                   : components(g_));
      y.coupling.push(d == deformation::extension ? times(with(k), mass_) : zero());
    }
    return y;
  }
};

} // namespace kanexpr::mechanics
