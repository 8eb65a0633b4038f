#pragma once

namespace kanexpr::mechanics {

/// The coefficients of the Magic Formula, with the names of Pacejka (2012), section 4.3.2 and appendix 3.
///
/// Omitted coefficients are 0; omitted scaling factors λ, pressures and qsy7 are 1. A .tir file has the same
/// names in capitals: pCx1 is PCX1, ppx1 is PPX1, qsx1 is QSX1; Fz0 is FNOMIN, R0 is UNLOADED_RADIUS, V0 is
/// LONGVL, `pressure` is INFLPRES and `nominal_pressure` is NOMPRES. The signs are those of .tir files (ISO
/// 8855): pKy1 is negative. An omitted coefficient is a `Value` without contents.
template <class Value>
struct magic_formula_coefficients {
  Value Fz0{}, R0{}, V0{};
  Value pCx1{}, pDx1{}, pDx2{}, pDx3{}, pEx1{}, pEx2{}, pEx3{}, pEx4{}, pKx1{}, pKx2{}, pKx3{}, pHx1{},
      pHx2{}, pVx1{}, pVx2{}, ppx1{}, ppx2{}, ppx3{}, ppx4{};
  Value rBx1{}, rBx2{}, rBx3{}, rCx1{}, rEx1{}, rEx2{}, rHx1{};
  Value pCy1{}, pDy1{}, pDy2{}, pDy3{}, pEy1{}, pEy2{}, pEy3{}, pEy4{}, pEy5{}, pKy1{}, pKy2{}, pKy3{},
      pKy4{}, pKy5{}, pKy6{}, pKy7{}, pHy1{}, pHy2{};
  Value pVy1{}, pVy2{}, pVy3{}, pVy4{}, ppy1{}, ppy2{}, ppy3{}, ppy4{}, ppy5{};
  Value rBy1{}, rBy2{}, rBy3{}, rBy4{}, rCy1{}, rEy1{}, rEy2{}, rHy1{}, rHy2{}, rVy1{}, rVy2{}, rVy3{},
      rVy4{}, rVy5{}, rVy6{};
  Value qBz1{}, qBz2{}, qBz3{}, qBz5{}, qBz6{}, qBz9{}, qBz10{}, qCz1{}, qDz1{}, qDz2{}, qDz3{}, qDz4{},
      qDz6{}, qDz7{}, qDz8{}, qDz9{}, qDz10{}, qDz11{};
  Value qEz1{}, qEz2{}, qEz3{}, qEz4{}, qEz5{}, qHz1{}, qHz2{}, qHz3{}, qHz4{}, ppz1{}, ppz2{}, ssz1{},
      ssz2{}, ssz3{}, ssz4{};
  Value qsx1{}, qsx2{}, qsx3{}, qsx4{}, qsx5{}, qsx6{}, qsx7{}, qsx8{}, qsx9{}, qsx10{}, qsx11{}, ppMx1{};
  Value qsy1{}, qsy2{}, qsy3{}, qsy4{}, qsy5{}, qsy6{}, qsy8{};
  Value pressure{}, nominal_pressure{};
  Value qsy7{};
  Value lambda_Fz0{}, lambda_mux{}, lambda_muy{}, lambda_Kxkappa{}, lambda_Kyalpha{}, lambda_Cx{},
      lambda_Cy{}, lambda_Ex{}, lambda_Ey{};
  Value lambda_Hx{}, lambda_Hy{}, lambda_Vx{}, lambda_Vy{}, lambda_Kygamma{}, lambda_Kzgamma{}, lambda_t{},
      lambda_Mr{}, lambda_xalpha{};
  Value lambda_ykappa{}, lambda_Vykappa{}, lambda_s{}, lambda_Mx{}, lambda_VMx{}, lambda_My{};

  /// Calls `visit` with all coefficients.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    each_coefficient(self, [&](auto&... c) { each_factor(self, [&](auto&... f) { visit(c..., f...); }); });
  }
  /// Calls `visit` with the coefficients that are 0 if they are omitted.
  template <class Self, class Visit>
  static constexpr void each_coefficient(Self& self, Visit&& visit) {
    visit(self.Fz0, self.R0, self.V0, self.pCx1, self.pDx1, self.pDx2, self.pDx3, self.pEx1, self.pEx2,
          self.pEx3, self.pEx4, self.pKx1, self.pKx2, self.pKx3, self.pHx1, self.pHx2, self.pVx1, self.pVx2,
          self.ppx1, self.ppx2, self.ppx3, self.ppx4, self.rBx1, self.rBx2, self.rBx3, self.rCx1, self.rEx1,
          self.rEx2, self.rHx1, self.pCy1, self.pDy1, self.pDy2, self.pDy3, self.pEy1, self.pEy2, self.pEy3,
          self.pEy4, self.pEy5, self.pKy1, self.pKy2, self.pKy3, self.pKy4, self.pKy5, self.pKy6, self.pKy7,
          self.pHy1, self.pHy2, self.pVy1, self.pVy2, self.pVy3, self.pVy4, self.ppy1, self.ppy2, self.ppy3,
          self.ppy4, self.ppy5, self.rBy1, self.rBy2, self.rBy3, self.rBy4, self.rCy1, self.rEy1, self.rEy2,
          self.rHy1, self.rHy2, self.rVy1, self.rVy2, self.rVy3, self.rVy4, self.rVy5, self.rVy6, self.qBz1,
          self.qBz2, self.qBz3, self.qBz5, self.qBz6, self.qBz9, self.qBz10, self.qCz1, self.qDz1, self.qDz2,
          self.qDz3, self.qDz4, self.qDz6, self.qDz7, self.qDz8, self.qDz9, self.qDz10, self.qDz11, self.qEz1,
          self.qEz2, self.qEz3, self.qEz4, self.qEz5, self.qHz1, self.qHz2, self.qHz3, self.qHz4, self.ppz1,
          self.ppz2, self.ssz1, self.ssz2, self.ssz3, self.ssz4, self.qsx1, self.qsx2, self.qsx3, self.qsx4,
          self.qsx5, self.qsx6, self.qsx7, self.qsx8, self.qsx9, self.qsx10, self.qsx11, self.ppMx1,
          self.qsy1, self.qsy2, self.qsy3, self.qsy4, self.qsy5, self.qsy6, self.qsy8);
  }
  /// Calls `visit` with the factors that are 1 if they are omitted.
  template <class Self, class Visit>
  static constexpr void each_factor(Self& self, Visit&& visit) {
    visit(self.pressure, self.nominal_pressure, self.qsy7, self.lambda_Fz0, self.lambda_mux, self.lambda_muy,
          self.lambda_Kxkappa, self.lambda_Kyalpha, self.lambda_Cx, self.lambda_Cy, self.lambda_Ex,
          self.lambda_Ey, self.lambda_Hx, self.lambda_Hy, self.lambda_Vx, self.lambda_Vy, self.lambda_Kygamma,
          self.lambda_Kzgamma, self.lambda_t, self.lambda_Mr, self.lambda_xalpha, self.lambda_ykappa,
          self.lambda_Vykappa, self.lambda_s, self.lambda_Mx, self.lambda_VMx, self.lambda_My);
  }
};

} // namespace kanexpr::mechanics
