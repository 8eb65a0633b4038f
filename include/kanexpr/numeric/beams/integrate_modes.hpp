#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/numeric/beams/gauss_legendre.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>
#include <kanexpr/numeric/beams/shape.hpp>

/// Computes the integrals over a beam and the values of its shapes at a place.
namespace kanexpr::numeric::beams {

/// A shape of a beam.
struct beam_shape {
  deformation what{};
  shape of{};
};

/// The shapes of a beam and the factors by which its stiffnesses, its mass per length and its polar inertia
/// per length vary along it.
struct beam_shapes {
  base::sequence<beam_shape> all{};
  base::sequence<shape> stiffness = base::sequence<shape>(4, shape::polynomial({1.0})); ///< by deformation
  shape mass = shape::polynomial({1.0});
  shape polar = shape::polynomial({1.0});
};

namespace detail {

/// Integrates over intervals on which all functions are smooth. The rule is exact for the polynomials that
/// occur; for waves, 16 more points on at most one wavelength of the shortest wave leave errors far below
/// rounding.
class integrator {
public:
  constexpr explicit integrator(const beam_shapes& b) {
    int of_shapes = 0, of_factors = larger(b.mass.degree(), b.polar.degree());
    double wave_number = 0;
    add(b.mass.stations(), 1), add(b.polar.stations(), 1);
    for (const beam_shape& s : b.all) {
      of_shapes = larger(of_shapes, s.of.degree());
      wave_number = s.of.wave_number() > wave_number ? s.of.wave_number() : wave_number;
    }
    for (const shape& s : b.stiffness) of_factors = larger(of_factors, s.degree()), add(s.stations(), 1);
    const int waves = 1 + static_cast<int>(wave_number / (2 * 3.141592653589793));
    for (const beam_shape& s : b.all) add(s.of.stations(), s.of.is_wave() ? waves : 1);
    // the integrands are at most ξ² μ, ξ μ φ, μ φ² and φ'² times the double integral of μ ξ
    const int degree = of_factors + 2 * of_shapes + 2;
    rule_ = gauss_legendre(degree / 2 + 1 + (wave_number > 0 ? 16 : 0));
    tail_rule_ = gauss_legendre((of_factors + 1) / 2 + 1);
  }

  /// The intervals, with ends in increasing order.
  constexpr const base::sequence<double>& ends() const { return ends_; }
  constexpr const quadrature& rule() const { return rule_; }
  constexpr const quadrature& tail_rule() const { return tail_rule_; }

private:
  static constexpr int larger(int a, int b) { return a > b ? a : b; }

  /// Adds stations, with each of their intervals divided into equal parts.
  constexpr void add(const base::sequence<double>& stations, int parts) {
    for (int i = 0; i + 1 < stations.size(); ++i)
      for (int j = 0; j < parts; ++j)
        insert(stations[i] +
               (stations[i + 1] - stations[i]) * static_cast<double>(j) / static_cast<double>(parts));
    insert(stations.back());
  }
  constexpr void insert(double xi) {
    int place = 0;
    while (place < ends_.size() && ends_[place] < xi) ++place;
    if (place < ends_.size() && !(xi < ends_[place])) return;
    ends_.push(xi);
    for (int i = ends_.size() - 1; i > place; --i) ends_[i] = ends_[i - 1];
    ends_[place] = xi;
  }

  base::sequence<double> ends_{};
  quadrature rule_{}, tail_rule_{};
};

/// ∫ μ and ∫ μ ξ from a place to the tip; with them, ∫ μ G_kl = ∫ φ'_k φ'_l ∫_ξ^1 μ.
struct tail {
  double zeroth = 0, first = 0;
  constexpr void add(const shape& mass, double from, double to, const quadrature& rule) {
    for (int i = 0; i < rule.size(); ++i) {
      const double xi = from + (to - from) * rule.nodes[i];
      const double part = (to - from) * rule.weights[i] * mass.at(xi).value;
      zeroth += part, first += part * xi;
    }
  }
};

/// Replaces integrals that are negligible relative to a bound by 0.
constexpr double without_rounding(double value, double bound_squared) {
  return value * value <= 1e-26 * bound_squared ? 0.0 : value;
}

/// The entries of `section_values` that are integrals from 0 to ξ, row by row.
constexpr base::sequence<double> integrals_to(const beam_shapes& b, double xi) {
  const int n = b.all.size();
  base::sequence<double> found(n * n, 0.0);
  const integrator by(b);
  for (int i = 0; i + 1 < by.ends().size(); ++i) {
    const double from = by.ends()[i], to = by.ends()[i + 1] < xi ? by.ends()[i + 1] : xi;
    for (int j = 0; j < by.rule().size() && from < to; ++j) {
      const double place = from + (to - from) * by.rule().nodes[j];
      base::sequence<deflection> at;
      at.reserve(n);
      for (const beam_shape& each : b.all) at.push(each.of.at(place));
      for (int k = 0; k < n; ++k)
        for (int l = 0; l < n; ++l) {
          const deformation what = b.all[k].what, other = b.all[l].what;
          const bool twists = what == deformation::first_bending && other == deformation::second_bending;
          if (!twists && (what != other || !is_bending(what))) continue;
          found[k * n + l] +=
              (to - from) * by.rule().weights[j] * (twists ? at[k].curvature : at[k].slope) * at[l].slope;
        }
    }
  }
  return found;
}

/// Whether the beam bends in natural modes of a free beam, which alone deflect the root.
constexpr bool is_free(const beam_shapes& b) {
  bool found = false;
  for (const beam_shape& s : b.all) {
    const double root = s.of.clean_at(0).value;
    found = found || (is_bending(s.what) && s.of.is_wave() && root * root > 0);
  }
  return found;
}

} // namespace detail

/// Sums the integrals.
class integral_sums {
public:
  constexpr explicit integral_sums(const beam_shapes& b)
      : beam_(b), n_(b.all.size()), sums_(modal_integrals::count(n_)) {
    const detail::integrator by(b);
    detail::tail beyond;
    for (int i = by.ends().size() - 2; i >= 0; --i) {
      const double from = by.ends()[i], to = by.ends()[i + 1];
      for (int j = 0; j < by.rule().size(); ++j) {
        const double xi = from + (to - from) * by.rule().nodes[j];
        detail::tail rest = beyond;
        rest.add(b.mass, xi, to, by.tail_rule());
        add_place(xi, (to - from) * by.rule().weights[j], rest);
      }
      beyond.add(b.mass, from, to, by.tail_rule());
    }
    if (detail::is_free(b)) keep_mass_center();
    drop_rounding();
  }

  constexpr const base::sequence<double>& numbers() const { return sums_; }

private:
  constexpr void add_place(double xi, double weight, const detail::tail& rest) {
    const double mass = weight * beam_.mass.at(xi).value, polar = weight * beam_.polar.at(xi).value;
    sums_[0] += mass, sums_[1] += mass * xi, sums_[2] += mass * xi * xi, sums_[3] += polar;
    base::sequence<deflection> at;
    at.reserve(n_);
    for (const beam_shape& s : beam_.all) at.push(s.of.at(xi));
    for (int k = 0; k < n_; ++k) {
      const deformation what = beam_.all[k].what;
      const double factor = what == deformation::torsion ? polar : mass;
      sums_[4 + k] += factor * at[k].value;
      sums_[4 + n_ + k] += factor * xi * at[k].value;
      const double stiffness = weight * beam_.stiffness[static_cast<int>(what)].at(xi).value;
      for (int l = 0; l < n_; ++l) {
        const deformation other = beam_.all[l].what;
        if ((what == deformation::torsion) == (other == deformation::torsion))
          entry(0, k, l) += factor * at[k].value * at[l].value;
        if (what != other) continue;
        const double slopes = at[k].slope * at[l].slope;
        entry(1, k, l) += stiffness * (is_bending(what) ? at[k].curvature * at[l].curvature : slopes);
        if (!is_bending(what)) continue;
        entry(2, k, l) += weight * rest.zeroth * slopes;
        entry(3, k, l) += weight * rest.first * slopes;
      }
    }
  }

  /// Measures the foreshortening from the mass center instead of the root.
  constexpr void keep_mass_center() {
    const base::sequence<double> there = detail::integrals_to(beam_, sums_[1] / sums_[0]);
    for (int which = 2; which < 4; ++which)
      for (int k = 0; k < n_; ++k)
        for (int l = 0; l < n_; ++l) {
          if (beam_.all[k].what != beam_.all[l].what) continue;
          const double mass = sums_[which - 2], bound = mass * mass * there[k * n_ + k] * there[l * n_ + l];
          entry(which, k, l) = detail::without_rounding(entry(which, k, l) - mass * there[k * n_ + l], bound);
        }
  }

  constexpr double& entry(int which, int k, int l) { return sums_[4 + 2 * n_ + (which * n_ + k) * n_ + l]; }

  /// The bounds are those of Cauchy and Schwarz.
  constexpr void drop_rounding() {
    for (int k = 0; k < n_; ++k) {
      const double mass = beam_.all[k].what == deformation::torsion ? sums_[3] : sums_[0];
      for (double* moment : {&sums_[4 + k], &sums_[4 + n_ + k]})
        *moment = detail::without_rounding(*moment, mass * entry(0, k, k));
    }
    for (int which = 0; which < 4; ++which)
      for (int k = 0; k < n_; ++k)
        for (int l = 0; l < k; ++l)
          entry(which, k, l) = entry(which, l, k) =
              detail::without_rounding(entry(which, k, l), entry(which, k, k) * entry(which, l, l));
  }

  const beam_shapes& beam_;
  int n_;
  base::sequence<double> sums_;
};

/// Returns the numbers to which `modal_integrals` refers.
constexpr base::sequence<double> integrate_modes(const beam_shapes& b) {
  const integral_sums sums(b);
  return sums.numbers();
}

/// Returns the numbers to which `section_values` refers, at ξ.
constexpr base::sequence<double> values_at(const beam_shapes& b, double xi) {
  const int n = b.all.size();
  base::sequence<double> found;
  found.reserve(section_values::count(n));
  found.push(xi);
  for (const beam_shape& s : b.all) found.push(s.of.clean_at(xi).value);
  for (const beam_shape& s : b.all) found.push(s.of.clean_at(xi).slope);
  for (const double each : detail::integrals_to(b, xi)) found.push(each);
  if (!detail::is_free(b)) return found;
  const base::sequence<double> sums = integrate_modes(b);
  const base::sequence<double> there = detail::integrals_to(b, sums[1] / sums[0]);
  for (int i = 0; i < n * n; ++i) found[1 + 2 * n + i] -= there[i];
  return found;
}

/// Returns the numbers of `count` equally spaced sections from the root to the tip, one section after the
/// other.
constexpr base::sequence<double> values_at_sections(const beam_shapes& b, int count) {
  base::sequence<double> all;
  all.reserve(count * section_values::count(b.all.size()));
  for (int i = 0; i < count; ++i)
    for (const double each : values_at(b, static_cast<double>(i) / (count - 1))) all.push(each);
  return all;
}

} // namespace kanexpr::numeric::beams
