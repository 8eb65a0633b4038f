#pragma once

#include <cmath>

/// The characteristic curves of muscles and tendons after De Groote, Kinney, Rao & Fregly, Evaluation of
/// direct collocation optimal control problem formulations for solving the muscle redundancy problem, Annals
/// of Biomedical Engineering 44 (2016), 2922–2936, with the constants that the paper's supplement gives.
///
/// Lengths are relative to the slack length of the tendon or the optimal length of the fiber, forces to the
/// peak isometric force, and velocities of the fiber to the maximal one; a positive velocity lengthens the
/// fiber. All functions take numbers or expressions.
namespace kanexpr::numeric::muscle_curves {

/// The factor in the exponent of the tendon's curve if the tendon is stretched by `strain` at the peak
/// isometric force. The paper's 35 corresponds to a strain of 0.0474; 0.049 gives 33.9367.
template <class Number>
constexpr Number tendon_factor(const Number& strain) {
  constexpr double log_of_25_quarters = 1.8325814637483102;
  return log_of_25_quarters / (strain + 0.005);
}

/// The force of a tendon, ⅕ e^(k (l − 0.995)) − ¼, which is zero at l = 0.995 + ln(1.25)/k, about 1.0016.
template <class Number>
constexpr Number tendon_force(const Number& length, const Number& strain) {
  using std::exp;
  const Number factor = tendon_factor(strain);
  return 0.2 * exp(factor * (length - 0.995)) - 0.25;
}

/// The length of a tendon with the given force, the inverse of `tendon_force`.
template <class Number>
constexpr Number tendon_length(const Number& force, const Number& strain) {
  using std::log;
  const Number factor = tendon_factor(strain);
  return 0.995 + log(5.0 * (force + 0.25)) / factor;
}

/// The passive force of a fiber, (e^(4 (l − 1)/ε) − 1)/(e⁴ − 1), which is 1 at the strain ε = l − 1.
template <class Number>
constexpr Number passive_force(const Number& length, const Number& strain) {
  using std::exp;
  constexpr double scale = 53.598150033144236; // e⁴ − 1
  const Number exponent = 4.0 * (length - 1.0) / strain;
  return (exp(exponent) - 1.0) / scale;
}

/// The length of a fiber with the given passive force, the inverse of `passive_force`.
template <class Number>
constexpr Number passive_length(const Number& force, const Number& strain) {
  using std::log;
  constexpr double scale = 53.598150033144236;
  return 1.0 + strain * log(scale * force + 1.0) / 4.0;
}

/// The active force of a fully activated fiber at rest: the sum of three bells bᵢ e^(−½ ((l − cᵢ)/wᵢ(l))²).
template <class Number>
constexpr Number active_force(const Number& length) {
  using std::exp;
  const Number first = (length - 1.06) / (0.0633 * length + 0.162);
  const Number second = (length - 0.717) / (0.2 * length - 0.0299);
  const Number third = (length - 1.0) / 0.354;
  const Number first_bell = 0.814 * exp(-0.5 * (first * first));
  const Number second_bell = 0.433 * exp(-0.5 * (second * second));
  const Number third_bell = 0.1 * exp(-0.5 * (third * third));
  return first_bell + second_bell + third_bell;
}

/// The constants of the velocity curve, d₁ arsinh(d₂ v + d₃) + d₄.
inline constexpr double velocity_scale = 0.318, velocity_factor = 8.149, velocity_shift = 0.374,
                        velocity_offset = 0.886;

/// The factor by which a velocity changes the active force.
template <class Number>
constexpr Number velocity_force(const Number& velocity) {
  using std::log, std::sqrt;
  const Number s = velocity_factor * velocity + velocity_shift;
  return velocity_scale * log(s + sqrt(s * s + 1.0)) + velocity_offset;
}

/// The velocity with the given factor, the inverse of `velocity_force`.
template <class Number>
constexpr Number velocity_with_force(const Number& force) {
  using std::sinh;
  return (sinh((force - velocity_offset) / velocity_scale) - velocity_shift) / velocity_factor;
}

} // namespace kanexpr::numeric::muscle_curves
