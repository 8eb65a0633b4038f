#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/numeric/elementary.hpp>

namespace kanexpr::numeric::beams {

/// A shape function φ at one place: φ, φ' and φ'' with respect to ξ.
struct deflection {
  double value = 0, slope = 0, curvature = 0;
};

/// A function of the fraction ξ = x/L of the length of a beam, 0 ≤ ξ ≤ 1: a polynomial on each interval
/// between stations, or a wave a sin βξ + b cos βξ + c exp(−βξ) + d exp(−β(1 − ξ)), as are the natural modes
/// of uniform beams and rods. With both exponentials at most 1, modes of any order are computed without
/// cancellation.
class shape {
public:
  constexpr shape() = default;

  /// The polynomial c_0 + c_1 ξ + c_2 ξ² + …
  static constexpr shape polynomial(const base::sequence<double>& coefficients) {
    return piecewise({0.0, 1.0}, coefficients.size() - 1, coefficients);
  }

  /// On the interval from stations[i] to stations[i + 1], c_0 + c_1 t + … with t = ξ − stations[i]; the
  /// coefficients of all intervals in order, degree + 1 for each.
  static constexpr shape piecewise(const base::sequence<double>& stations, int degree,
                                   const base::sequence<double>& coefficients) {
    shape s;
    s.stations_ = stations;
    s.degree_ = degree;
    s.coefficients_ = coefficients;
    return s;
  }

  static constexpr shape wave(double wave_number, double sine, double cosine, double from_root,
                              double from_tip) {
    shape s;
    s.stations_ = {0.0, 1.0};
    s.wave_number_ = wave_number;
    s.coefficients_ = {sine, cosine, from_root, from_tip};
    return s;
  }

  constexpr deflection at(double xi) const { return is_wave() ? wave_at(xi) : polynomial_at(xi); }

  /// The same, in which values and slopes that vanish except for rounding are exactly 0.
  constexpr deflection clean_at(double xi) const {
    deflection d = at(xi);
    double size = 0;
    for (const double c : coefficients_) size += elementary::abs(c);
    if (elementary::abs(d.value) < 1e-14 * size) d.value = 0;
    if (elementary::abs(d.slope) < 1e-14 * size * (1 + wave_number_)) d.slope = 0;
    return d;
  }

  /// The ends of the intervals on which the function is smooth, from 0 to 1.
  constexpr const base::sequence<double>& stations() const { return stations_; }
  /// The degree of the polynomials; 0 for a wave.
  constexpr int degree() const { return degree_; }
  /// β of a wave, 0 for polynomials.
  constexpr double wave_number() const { return wave_number_; }
  constexpr bool is_wave() const { return wave_number_ > 0; }

  /// Whether it has no numbers, as a natural mode whose number or tip load is invalid.
  constexpr bool is_empty() const { return coefficients_.empty(); }

  /// Whether the function is given by finite numbers on the whole beam: stations in increasing order from 0
  /// to 1, and all coefficients of each interval.
  constexpr bool is_complete() const {
    const int intervals = stations_.size() - 1;
    if (intervals < 1 || degree_ < 0) return false;
    bool holds = elementary::abs(stations_[0]) <= 0 && elementary::abs(stations_.back() - 1) <= 0;
    for (int i = 0; i < intervals; ++i) holds = holds && stations_[i] < stations_[i + 1];
    for (const double c : coefficients_) holds = holds && elementary::abs(c) < 1e300;
    return holds && coefficients_.size() == (is_wave() ? 4 : intervals * (degree_ + 1));
  }

  /// Whether the function, and its slope if the beam bends, are continuous at the stations, within a
  /// millionth of the coefficients.
  constexpr bool is_smooth(bool bends) const {
    double size = 0;
    for (const double c : coefficients_) size += elementary::abs(c);
    bool holds = true;
    for (int i = 1; i + 1 < stations_.size() && !is_wave(); ++i) {
      const deflection before = at(stations_[i]), after = piece_at(i, 0);
      holds = holds && elementary::abs(after.value - before.value) <= 1e-6 * size &&
              (!bends || elementary::abs(after.slope - before.slope) <= 1e-6 * size);
    }
    return holds;
  }

  constexpr shape scaled(double factor) const {
    shape s = *this;
    for (double& c : s.coefficients_) c *= factor;
    return s;
  }

private:
  constexpr deflection wave_at(double xi) const {
    const double angle = wave_number_ * xi;
    const double sine = elementary::sin(angle), cosine = elementary::cos(angle);
    const double oscillating = coefficients_[0] * sine + coefficients_[1] * cosine;
    const double turned = coefficients_[0] * cosine - coefficients_[1] * sine;
    const double falling = coefficients_[2] * elementary::exp(-angle);
    const double rising = coefficients_[3] * elementary::exp(angle - wave_number_);
    return {oscillating + falling + rising, wave_number_ * (turned - falling + rising),
            wave_number_ * wave_number_ * (falling + rising - oscillating)};
  }

  constexpr deflection polynomial_at(double xi) const {
    int piece = 0;
    while (piece + 2 < stations_.size() && xi > stations_[piece + 1]) ++piece;
    return piece_at(piece, xi - stations_[piece]);
  }

  /// The polynomial of one interval, at t from its beginning.
  constexpr deflection piece_at(int piece, double t) const {
    deflection d;
    for (int i = degree_; i >= 0; --i) {
      d.curvature = d.curvature * t + 2 * d.slope;
      d.slope = d.slope * t + d.value;
      d.value = d.value * t + coefficients_[piece * (degree_ + 1) + i];
    }
    return d;
  }

  base::sequence<double> stations_{};
  base::sequence<double> coefficients_{};
  int degree_ = 0;
  double wave_number_ = 0;
};

/// Whether a function can be the factor of a mass or of a stiffness: nowhere negative, and positive at some
/// of 65 places.
constexpr bool is_factor(const shape& s) {
  double least = 0, greatest = 0;
  for (int i = 0; i <= 64; ++i) {
    const double value = s.at(i / 64.0).value;
    least = value < least ? value : least;
    greatest = value > greatest ? value : greatest;
  }
  return greatest > 0 && least >= -1e-12 * greatest;
}

/// Whether a shape leaves a clamped root at rest, including its slope if the beam bends.
constexpr bool fits_clamped_root(const shape& s, bool bends) {
  const deflection root = s.clean_at(0);
  return root.value * root.value + (bends ? root.slope * root.slope : 0) < 1e-18;
}

} // namespace kanexpr::numeric::beams
