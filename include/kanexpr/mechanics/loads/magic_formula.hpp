#pragma once

#include <kanexpr/mechanics/loads/magic_formula_coefficients.hpp>
#include <kanexpr/mechanics/loads/one_sided.hpp>
#include <kanexpr/mechanics/loads/tyre_slip.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <numbers>
#include <string_view>

namespace kanexpr::mechanics {

/// The Magic Formula for combined slip with camber and inflation pressure, without turn slip: Pacejka (2012),
/// section 4.3.2, equations 4.E1 to 4.E78. In its notation κ is the slip `forward`, α* is −`lateral` and γ* =
/// sin γ, which also replaces γ in 4.E69 and 4.E70.
///
/// It differs from the book where that is not smooth. sgn x is x/√(x² + 10⁻¹²); |γ*| is γ*²/√(γ*² + 10⁻⁶);
/// α_t,eq and α_r,eq contain 10⁻¹² under the root; the factors E approach their limit 1 smoothly from 0.95
/// on; ε_V is the speed of standstill. If the wheel rolls backward, the pneumatic trail is ahead of the
/// contact (4.E42 keeps it behind).
class magic_formula {
  using expression = symbolic::expression;

  /// A side force F_yo, and the terms on which the aligning moment and the combined slip depend.
  struct side_force {
    expression force{}, stiffness{}, shift{}, offset{}, friction{}, slope{};
  };

public:
  using coefficients = magic_formula_coefficients<expression>;

  constexpr magic_formula(const coefficients& of, const tyre_slip& at)
      : c(of), s(at), kappa_(at.forward), alpha_(-at.lateral), gamma_(at.camber) {
    const expression nominal = c.lambda_Fz0 * c.Fz0, excess = s.load - nominal;
    nominal_ = nominal, load_ = excess / nominal;
    pressure_ = (c.pressure - c.nominal_pressure) / c.nominal_pressure;
    squared_ = gamma_ * gamma_;
    lean_ = smooth_magnitude(squared_, number(1e-3));
    least_ = number(1e-9) * nominal_;
    const expression secant = sqrt(1 + alpha_ * alpha_);
    cosine_ = s.direction / secant;
  }

  constexpr tyre_effort effort() const {
    const expression stiffness = slip_stiffness(); // Kxκ
    tyre_effort f;
    f.forward = combined_forward(stiffness);
    const side_force leaning = pure_lateral(gamma_), upright = pure_lateral(number(0));
    f.lateral = lateral_weight(gamma_) * leaning.force;
    f.lateral += ply_steer(leaning);
    const expression carried = lateral_weight(number(0)) * upright.force; // F'y, 4.E74
    f.aligning = aligning(leaning, carried, stiffness);
    f.aligning += scrub(f);
    f.overturning = overturning(f), f.rolling = rolling(f);
    return f;
  }

private:
  constexpr expression number(double value) const { return s.load.number(symbolic::real(value)); }
  constexpr expression with_load(expression a, expression b) const { return a + b * load_; }
  constexpr expression with_load(expression a, expression b, expression d) const {
    return a + load_ * (b + d * load_);
  }
  constexpr expression with_pressure(expression a, expression b) const {
    return 1 + pressure_ * (a + b * pressure_);
  }
  constexpr expression sign(expression x) const {
    const expression square = x * x;
    return x / sqrt(square + number(1e-12));
  }
  /// E, which must not exceed 1.
  constexpr expression limited(expression e) const {
    const expression below = number(1.05) - e;
    return 1 - one_sided(below, number(0.1));
  }
  /// C arctan(B x − E (B x − arctan(B x)))
  static constexpr expression bent(expression b, expression shape, expression e, expression x) {
    const expression steep = b * x, excess = steep - atan(steep);
    return shape * atan(steep - e * excess);
  }
  /// λ'μ, 4.E8
  static constexpr expression digressive(expression lambda) {
    const expression below = 1 + 9 * lambda;
    return 10 * lambda / below;
  }
  /// 1/K for a stiffness K that vanishes with the load
  constexpr expression inverse_of(expression stiffness) const {
    const expression square = stiffness * stiffness;
    return stiffness / (square + least_ * least_);
  }

  constexpr expression slip_stiffness() const; ///< 4.E15
  constexpr expression combined_forward(expression stiffness) const;
  constexpr expression cornering_stiffness(expression gamma) const;
  constexpr side_force pure_lateral(expression gamma) const;
  constexpr expression lateral_weight(expression gamma) const; ///< G_yκ
  constexpr expression ply_steer(const side_force& at) const;  ///< S_Vyκ
  constexpr expression trail(expression stretch) const;
  constexpr expression aligning(const side_force& at, expression carried, expression stiffness) const;
  constexpr expression scrub(const tyre_effort& f) const; ///< s Fx
  constexpr expression overturning(const tyre_effort& f) const;
  constexpr expression rolling(const tyre_effort& f) const;

  const coefficients& c;
  const tyre_slip& s;
  expression kappa_, alpha_, gamma_;
  expression nominal_{}, load_{}, pressure_{}; ///< F'zo, df_z and dp_i
  expression squared_{}, lean_{};              ///< γ*² and |γ*|
  expression least_{};                         ///< a force that is small compared with F'zo
  expression cosine_{};                        ///< cos'α, negative if the wheel rolls backward
};

constexpr symbolic::expression magic_formula::slip_stiffness() const {
  const expression growth = with_load(c.pKx1, c.pKx2), fading = exp(c.pKx3 * load_);
  const expression hard = with_pressure(c.ppx1, c.ppx2);
  return s.load * growth * fading * hard * c.lambda_Kxkappa;
}

/// 4.E9 to 4.E18 and 4.E50 to 4.E57
constexpr symbolic::expression magic_formula::combined_forward(expression stiffness) const {
  const expression plain = with_load(c.pDx1, c.pDx2);
  if (plain.is_zero()) return number(0);
  const expression hard = with_pressure(c.ppx3, c.ppx4), tilt = 1 - c.pDx3 * squared_;
  const expression friction = plain * hard * tilt * c.lambda_mux;
  const expression peak = friction * s.load, shape = c.pCx1 * c.lambda_Cx;
  const expression slope = stiffness / (shape * peak + least_);
  const expression shift = with_load(c.pHx1, c.pHx2) * c.lambda_Hx, x = kappa_ + shift;
  const expression skew = 1 - c.pEx4 * sign(x);
  const expression curvature = limited(with_load(c.pEx1, c.pEx2, c.pEx3) * skew * c.lambda_Ex);
  const expression moving = s.direction * s.direction, digression = digressive(c.lambda_mux);
  const expression offset = s.load * with_load(c.pVx1, c.pVx2) * c.lambda_Vx * digression * moving;
  const expression pure = peak * sin(bent(slope, shape, curvature, x)) + offset;
  const expression base = c.rBx1 + c.rBx3 * squared_, narrowing = cos(atan(c.rBx2 * kappa_));
  const expression b = base * narrowing * c.lambda_xalpha, e = limited(with_load(c.rEx1, c.rEx2));
  const expression weight = cos(bent(b, c.rCx1, e, alpha_ + c.rHx1));
  return weight / cos(bent(b, c.rCx1, e, c.rHx1)) * pure;
}

/// 4.E25
constexpr symbolic::expression magic_formula::cornering_stiffness(expression gamma) const {
  const expression softening = gamma.is_zero() ? number(1) : 1 - c.pKy3 * lean_;
  const expression at_peak = c.pKy2 + c.pKy5 * (gamma * gamma), soft = 1 + c.ppy2 * pressure_;
  const expression relative = s.load / (nominal_ * at_peak * soft), hard = 1 + c.ppy1 * pressure_;
  const expression rise = sin(c.pKy4 * atan(relative));
  return c.pKy1 * nominal_ * hard * softening * rise * c.lambda_Kyalpha;
}

/// 4.E19 to 4.E30
constexpr magic_formula::side_force magic_formula::pure_lateral(expression gamma) const {
  const expression zero = number(0), plain = with_load(c.pDy1, c.pDy2), squared = gamma * gamma;
  if (plain.is_zero()) return {zero, zero, zero, zero, zero, zero};
  side_force f;
  f.stiffness = cornering_stiffness(gamma);
  const expression grip = with_pressure(c.ppy3, c.ppy4), tilt = 1 - c.pDy3 * squared;
  f.friction = plain * grip * tilt * c.lambda_muy;
  const expression digression = digressive(c.lambda_muy), hard = 1 + c.ppy5 * pressure_;
  const expression thrust = with_load(c.pVy3, c.pVy4) * s.load * gamma * c.lambda_Kygamma * digression;
  const expression camber = with_load(c.pKy6, c.pKy7) * s.load * hard * c.lambda_Kygamma * gamma;
  const expression inverse = inverse_of(f.stiffness), by_camber = (camber - thrust) * inverse;
  f.shift = with_load(c.pHy1, c.pHy2) * c.lambda_Hy + by_camber;
  f.offset = with_load(c.pVy1, c.pVy2) * s.load * c.lambda_Vy * digression + thrust;
  const expression peak = f.friction * s.load, shape = c.pCy1 * c.lambda_Cy, x = alpha_ + f.shift;
  const expression side = sign(x), asymmetry = (c.pEy3 + c.pEy4 * gamma) * side;
  const expression skew = 1 + c.pEy5 * squared - asymmetry;
  const expression curvature = limited(with_load(c.pEy1, c.pEy2) * skew * c.lambda_Ey);
  const expression slope = f.stiffness / (shape * peak + least_);
  f.force = peak * sin(bent(slope, shape, curvature, x)) + f.offset;
  f.slope = slope * shape; // By Cy
  return f;
}

/// 4.E59 to 4.E65
constexpr symbolic::expression magic_formula::lateral_weight(expression gamma) const {
  const expression base = c.rBy1 + c.rBy4 * (gamma * gamma);
  const expression b = base * cos(atan(c.rBy2 * (alpha_ - c.rBy3))) * c.lambda_ykappa;
  const expression e = limited(with_load(c.rEy1, c.rEy2)), shift = with_load(c.rHy1, c.rHy2);
  const expression weight = cos(bent(b, c.rCy1, e, kappa_ + shift));
  return weight / cos(bent(b, c.rCy1, e, shift));
}

/// 4.E66 and 4.E67
constexpr symbolic::expression magic_formula::ply_steer(const side_force& at) const {
  const expression of_camber = c.rVy3 * gamma_, level = with_load(c.rVy1, c.rVy2) + of_camber;
  const expression narrowing = cos(atan(c.rVy4 * alpha_));
  const expression height = at.friction * s.load * level * narrowing;
  return height * sin(c.rVy5 * atan(c.rVy6 * kappa_)) * c.lambda_Vykappa;
}

/// t, 4.E33 to 4.E44 and 4.E73. `stretch` is the square of K_xκ κ/K'_yα.
constexpr symbolic::expression magic_formula::trail(expression stretch) const {
  const expression share = with_load(c.qDz1, c.qDz2), lever = s.load * c.R0 / nominal_ * share;
  if (lever.is_zero()) return lever;
  const expression hard = 1 - c.ppz1 * pressure_, wide = c.qDz4 * squared_;
  const expression leaning = 1 + c.qDz3 * lean_ + wide;
  const expression peak = lever * hard * leaning * c.lambda_t;
  const expression ratio = c.lambda_Kyalpha / c.lambda_muy, steep = c.qBz6 * squared_;
  const expression tilt = 1 + c.qBz5 * lean_ + steep;
  const expression b = with_load(c.qBz1, c.qBz2, c.qBz3) * tilt * ratio;
  const expression turned = with_load(c.qHz3, c.qHz4) * gamma_, shift = with_load(c.qHz1, c.qHz2) + turned;
  const expression x = alpha_ + shift, angle = atan(b * c.qCz1 * x);
  const expression quarters = angle * number(2 / std::numbers::pi);
  const expression skew = 1 + (c.qEz4 + c.qEz5 * gamma_) * quarters;
  const expression e = limited(with_load(c.qEz1, c.qEz2, c.qEz3) * skew);
  const expression equivalent = sqrt(x * x + stretch);
  return peak * cos(bent(b, c.qCz1, e, equivalent)) * cosine_;
}

/// −t F'y + Mzr, 4.E36 to 4.E47, 4.E71 to 4.E78
constexpr symbolic::expression magic_formula::aligning(const side_force& at, expression carried,
                                                       expression stiffness) const {
  const expression inverse = inverse_of(at.stiffness), stretch = stiffness * inverse * kappa_;
  const expression tiny = number(1e-12), square = stretch * stretch + tiny;
  const expression behind = trail(square) * carried;
  const expression by_load = with_load(c.qDz6, c.qDz7) * c.lambda_Mr, hard = 1 + c.ppz2 * pressure_;
  const expression tilted = with_load(c.qDz10, c.qDz11) * lean_;
  const expression turned = (with_load(c.qDz8, c.qDz9) * hard + tilted) * gamma_ * c.lambda_Kzgamma;
  const expression share = by_load + turned;
  const expression peak = s.load * c.R0 * share * cosine_ * s.direction * c.lambda_muy;
  const expression ratio = c.lambda_Kyalpha / c.lambda_muy, preferred = c.qBz10 * at.slope;
  const expression b = c.qBz9 * ratio + preferred, raised = at.offset * inverse;
  const expression x = alpha_ + at.shift + raised;
  const expression equivalent = sqrt(x * x + square);
  return peak * cos(atan(b * equivalent)) - behind;
}

/// 4.E76
constexpr symbolic::expression magic_formula::scrub(const tyre_effort& f) const {
  const expression constant = c.ssz1 + c.ssz2 * (f.lateral / nominal_);
  const expression arm = constant + with_load(c.ssz3, c.ssz4) * gamma_;
  return c.R0 * arm * c.lambda_s * f.forward;
}

/// 4.E69
constexpr symbolic::expression magic_formula::overturning(const tyre_effort& f) const {
  const expression across = f.lateral / c.Fz0, relative = s.load / c.Fz0, load = c.qsx6 * relative;
  const expression steep = c.qsx8 * atan(c.qsx9 * across), hard = 1 + c.ppMx1 * pressure_;
  const expression wave = sin(c.qsx7 * gamma_ + steep), decay = c.qsx4 * cos(c.qsx5 * atan(load * load));
  expression sum = c.qsx1 * c.lambda_VMx;
  sum -= c.qsx2 * gamma_ * hard;
  sum += c.qsx3 * across;
  sum += decay * wave;
  sum += c.qsx10 * atan(c.qsx11 * relative) * gamma_;
  return c.R0 * s.load * c.lambda_Mx * sum;
}

/// 4.E70
constexpr symbolic::expression magic_formula::rolling(const tyre_effort& f) const {
  const expression relative = s.load / c.Fz0;
  expression sum = c.qsy1 + c.qsy2 * (f.forward / c.Fz0);
  if (!c.qsy3.is_zero() || !c.qsy4.is_zero()) {
    const expression fast = s.velocity / c.V0, square = fast * fast;
    sum += c.qsy3 * (fast * s.direction);
    sum += c.qsy4 * (square * square);
  }
  sum += (c.qsy5 + c.qsy6 * relative) * squared_;
  if (sum.is_zero()) return sum;
  const expression by_load = c.qsy7.is_one() ? relative : power(relative + number(1e-12), c.qsy7);
  const expression by_pressure = power(c.pressure / c.nominal_pressure, c.qsy8);
  return -(c.R0 * c.Fz0 * c.lambda_My * sum * by_load * by_pressure * s.direction);
}

/// The name of a coefficient by which the formula divides, but which is zero; empty if there is none.
constexpr std::string_view missing_coefficient(const magic_formula::coefficients& c) {
  if (c.Fz0.is_zero()) return "Fz0";
  if (c.R0.is_zero()) return "R0";
  const bool is_by_speed = !c.qsy3.is_zero() || !c.qsy4.is_zero();
  if (is_by_speed && c.V0.is_zero()) return "V0";
  const bool is_forward = !c.pDx1.is_zero() || !c.pDx2.is_zero();
  const bool is_lateral = !c.pDy1.is_zero() || !c.pDy2.is_zero();
  if (is_forward && c.pCx1.is_zero()) return "pCx1";
  if (is_forward && c.pKx1.is_zero() && c.pKx2.is_zero()) return "pKx1";
  if (is_lateral && c.pCy1.is_zero()) return "pCy1";
  if (is_lateral && c.pKy1.is_zero()) return "pKy1";
  if (is_lateral && c.pKy4.is_zero()) return "pKy4";
  if (is_lateral && c.pKy2.is_zero() && c.pKy5.is_zero()) return "pKy2";
  return {};
}

} // namespace kanexpr::mechanics
