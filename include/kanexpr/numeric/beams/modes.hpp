#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/beams/shape.hpp>
#include <kanexpr/numeric/elementary.hpp>

/// Natural modes of uniform Euler-Bernoulli beams and of rods in torsion or extension.
namespace kanexpr::numeric::beams {

/// How the ends of a beam are held, the root (ξ = 0) first.
enum class ends : unsigned char {
  clamped_free,
  clamped_clamped,
  clamped_pinned,
  pinned_pinned,
  pinned_free,
  free_free,
};

/// A rigid body at the tip: its mass divided by the mass of the beam, and its moment of inertia about the tip
/// divided by the mass times the square of the length of the beam. For a rod, `mass` is the ratio of the
/// inertias about its axis if it twists. Ratios above 1e10 count as 1e10, which changes the modes by less
/// than 1e-10.
struct tip_load {
  double mass = 0, inertia = 0;

  /// Whether the ratios are numbers and not negative.
  constexpr bool is_given() const { return mass >= 0 && inertia >= 0; }
  constexpr tip_load limited() const { return {mass < 1e10 ? mass : 1e10, inertia < 1e10 ? inertia : 1e10}; }
};

namespace detail {

inline constexpr double pi = 3.141592653589793;

/// φ and its derivatives up to the third, divided by the powers of β.
struct jet {
  double of[4]{};
};

constexpr jet combined(double a, const jet& x, double b, const jet& y) {
  jet sum;
  for (int i = 0; i < 4; ++i) sum.of[i] = a * x.of[i] + b * y.of[i];
  return sum;
}

/// The two solutions of φ'''' = β⁴φ that satisfy the conditions at the root, as coefficients of a wave, and
/// what the conditions at the tip leave of each.
class boundary_problem {
public:
  constexpr boundary_problem(ends how, const tip_load& tip, double wave_number)
      : how_(how), tip_(tip), beta_(wave_number), decay_(elementary::exp(-wave_number)) {
    const double s = elementary::sin(beta_), c = elementary::cos(beta_), e = decay_;
    const jet sine{{s, c, -s, -c}}, cosine{{c, -s, -c, s}}, from_root{{e, -e, e, -e}}, from_tip{{1, 1, 1, 1}};
    const auto at_tip = [&](const double* w) {
      return combined(1, combined(w[0], sine, w[1], cosine), 1, combined(w[2], from_root, w[3], from_tip));
    };
    set_root();
    for (int i = 0; i < 2; ++i) {
      const jet tip_of = at_tip(solution_[i]);
      first_[i] = first_condition(tip_of);
      second_[i] = second_condition(tip_of);
    }
  }

  /// Vanishes at the natural frequencies.
  constexpr double determinant() const { return first_[0] * second_[1] - first_[1] * second_[0]; }

  /// The wave that satisfies all conditions if the determinant vanishes.
  constexpr shape mode() const {
    const bool by_first = elementary::abs(first_[1]) >= elementary::abs(second_[1]);
    const double other = by_first ? -first_[0] / first_[1] : -second_[0] / second_[1];
    double w[4]{};
    for (int i = 0; i < 4; ++i) w[i] = solution_[0][i] + other * solution_[1][i];
    return shape::wave(beta_, w[0], w[1], w[2], w[3]);
  }

private:
  constexpr void set_root() {
    const double e = decay_;
    switch (how_) {
    case ends::clamped_free:
    case ends::clamped_clamped:
    case ends::clamped_pinned: return set(1, -1, 1, 0, -e, -e, 0, 1);
    case ends::pinned_pinned:
    case ends::pinned_free: return set(1, 0, 0, 0, 0, 0, -e, 1);
    case ends::free_free: return set(-1, 1, 1, 0, e, e, 0, 1);
    }
  }
  constexpr void set(double a0, double b0, double c0, double d0, double a1, double b1, double c1, double d1) {
    const double all[2][4]{{a0, b0, c0, d0}, {a1, b1, c1, d1}};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 4; ++j) solution_[i][j] = all[i][j];
  }

  /// The deflection, or the moment of a free tip.
  constexpr double first_condition(const jet& tip) const {
    if (is_free()) return tip.of[2] - beta_ * beta_ * beta_ * tip_.inertia * tip.of[1];
    return tip.of[0];
  }
  /// The slope of a clamped tip, the moment of a pinned one or the shear force of a free one.
  constexpr double second_condition(const jet& tip) const {
    if (is_free()) return tip.of[3] + beta_ * tip_.mass * tip.of[0];
    return how_ == ends::clamped_clamped ? tip.of[1] : tip.of[2];
  }
  constexpr bool is_free() const {
    return how_ == ends::clamped_free || how_ == ends::pinned_free || how_ == ends::free_free;
  }

  ends how_;
  tip_load tip_;
  double beta_, decay_;
  double solution_[2][4]{};
  double first_[2]{}, second_[2]{};
};

/// The root of a function between two places at which its signs differ: bisection to one percent, then the
/// secant method.
template <class Function>
constexpr double root_between(double low, double high, Function f) {
  double at_low = f(low), at_high = f(high);
  while (high - low > 0.01 * high) {
    const double middle = (low + high) / 2, value = f(middle);
    if ((value < 0) == (at_low < 0))
      low = middle, at_low = value;
    else
      high = middle, at_high = value;
  }
  double a = low, b = high, fa = at_low, fb = at_high;
  for (int i = 0; i < 12 && !base::equal(fa, fb) && !base::equal(fb, 0.0); ++i) {
    const double next = b - fb * (b - a) / (fb - fa);
    a = b, fa = fb;
    b = next, fb = f(b);
    if (elementary::abs(b - a) < 1e-15 * b) break;
  }
  return b;
}

constexpr double root_of_determinant(ends how, const tip_load& tip, double low, double high) {
  return root_between(low, high, [&](double beta) {
    const boundary_problem problem(how, tip, beta);
    return problem.determinant();
  });
}

} // namespace detail

/// β_n L of the n-th natural mode of bending, counted from 1 without the rigid motions; 0 if n < 1: ω = (β_n
/// L)² √(EI/(m L⁴)). Blevins, Formulas for Natural Frequency and Mode Shape (1979), table 8-1. A load at the
/// tip lowers the frequencies so that they interlace with those without it, which brackets each.
constexpr double wave_number_of_bending(ends how, int n, const tip_load& given = {}) {
  if (n < 1 || !given.is_given()) return 0;
  const tip_load tip = given.limited();
  const double turns = detail::pi * static_cast<double>(n);
  switch (how) {
  case ends::pinned_pinned: return turns;
  case ends::clamped_free: {
    if (tip.inertia > 0) {
      const tip_load of_mass{tip.mass, 0};
      return detail::root_of_determinant(how, tip, n > 1 ? wave_number_of_bending(how, n - 1, of_mass) : 1e-3,
                                         wave_number_of_bending(how, n, of_mass));
    }
    if (tip.mass > 0)
      return detail::root_of_determinant(how, tip, n > 1 ? wave_number_of_bending(how, n - 1) : 1e-3,
                                         wave_number_of_bending(how, n));
    return detail::root_of_determinant(how, tip, turns - detail::pi, turns);
  }
  case ends::clamped_clamped:
  case ends::free_free: return detail::root_of_determinant(how, tip, turns, turns + detail::pi);
  case ends::clamped_pinned:
  case ends::pinned_free: return detail::root_of_determinant(how, tip, turns, turns + detail::pi / 2);
  }
  return 0;
}

/// The shape scaled to 1 at the tip, or to the greatest deflection 1 if the tip is held.
constexpr shape normalized(const shape& given, bool tip_moves) {
  if (tip_moves) return given.scaled(1 / given.at(1).value);
  const int places = 8 + 8 * static_cast<int>(given.wave_number());
  double greatest = 0, where = 0;
  for (int i = 1; i < places; ++i) {
    const double xi = static_cast<double>(i) / static_cast<double>(places), value = given.at(xi).value;
    if (elementary::abs(value) > 1.000001 * elementary::abs(greatest)) greatest = value, where = xi;
  }
  for (int i = 0; i < 6; ++i) { // Newton's method for φ' = 0
    const deflection d = given.at(where);
    where -= d.slope / d.curvature;
  }
  return given.scaled(1 / given.at(where).value);
}

/// The n-th natural mode of bending; an empty shape if n < 1 or a ratio of the tip load is negative.
constexpr shape mode_of_bending(ends how, int n, const tip_load& given = {}) {
  if (n < 1 || !given.is_given()) return {};
  const tip_load tip = given.limited();
  const double beta = wave_number_of_bending(how, n, tip);
  if (how == ends::pinned_pinned) return shape::wave(beta, 1, 0, 0, 0);
  const bool tip_moves = how == ends::clamped_free || how == ends::pinned_free || how == ends::free_free;
  return normalized(detail::boundary_problem(how, tip, beta).mode(), tip_moves);
}

/// β_n L of the n-th natural mode of a rod in torsion or extension, ω = β_n √(GJ/I) or β_n √(EA/m). A held
/// end is clamped or pinned. With a tip load of ratio μ: cot βL = μ βL.
constexpr double wave_number_of_rod(ends how, int n, const tip_load& tip = {}) {
  if (n < 1 || !tip.is_given()) return 0;
  const double turns = detail::pi * static_cast<double>(n);
  if (how != ends::clamped_free && how != ends::pinned_free) return turns;
  if (!(tip.mass > 0)) return turns - detail::pi / 2;
  return detail::root_between(turns - detail::pi, turns - detail::pi / 2, [&](double beta) {
    return elementary::cos(beta) - tip.mass * beta * elementary::sin(beta);
  });
}

/// The n-th natural mode of a rod in torsion or extension, scaled like those of bending; an empty shape as
/// above.
constexpr shape mode_of_rod(ends how, int n, const tip_load& tip = {}) {
  if (n < 1 || !tip.is_given()) return {};
  const double beta = wave_number_of_rod(how, n, tip);
  if (how == ends::free_free) return shape::wave(beta, 0, n % 2 == 0 ? 1 : -1, 0, 0);
  const bool tip_moves = how == ends::clamped_free || how == ends::pinned_free;
  return shape::wave(beta, tip_moves ? 1 / elementary::sin(beta) : 1, 0, 0, 0);
}

} // namespace kanexpr::numeric::beams
