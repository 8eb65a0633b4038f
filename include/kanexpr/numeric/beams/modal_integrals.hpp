#pragma once

/// The integrals over a beam that enter its equations of motion, as pure numbers: lengths are divided by L,
/// masses by the reference mass per length times L, and stiffnesses by their reference values.
namespace kanexpr::numeric::beams {

/// How an amplitude deforms the beam.
enum class deformation : unsigned char {
  first_bending,  ///< deflects it in the first direction across the axis
  second_bending, ///< deflects it in the second one
  torsion,        ///< turns its sections about the axis
  extension,      ///< stretches it along the axis
};

constexpr bool is_bending(deformation d) {
  return d == deformation::first_bending || d == deformation::second_bending;
}

/// Refers to the integrals, which are stored as one array. Integrals are over ξ from 0 to 1; μ is the factor
/// of the mass or, for shapes of torsion, of the polar inertia. Entries that vanish except for rounding are
/// exactly 0.
struct modal_integrals {
  const double* numbers = nullptr;
  int shapes = 0;

  static constexpr int count(int shapes) { return 4 + 2 * shapes + 4 * shapes * shapes; }

  constexpr double mass() const { return numbers[0]; }            ///< ∫ μ
  constexpr double first_moment() const { return numbers[1]; }    ///< ∫ μ ξ
  constexpr double second_moment() const { return numbers[2]; }   ///< ∫ μ ξ²
  constexpr double polar() const { return numbers[3]; }           ///< ∫ of the factor of the polar inertia
  constexpr double zeroth(int k) const { return numbers[4 + k]; } ///< ∫ μ φ_k
  constexpr double first(int k) const { return numbers[4 + shapes + k]; } ///< ∫ μ ξ φ_k
  /// ∫ μ φ_k φ_l; 0 between torsion and other deformations.
  constexpr double product(int k, int l) const { return table(0, k, l); }
  /// ∫ s φ''_k φ''_l in bending, ∫ s φ'_k φ'_l in torsion and extension, with the factor s of the stiffness.
  constexpr double stiffness(int k, int l) const { return table(1, k, l); }
  /// ∫ μ G_kl with the foreshortening G_kl(ξ) = ∫ φ'_k φ'_l of bending in one direction, from the root to ξ
  /// or, for modes of a free beam, from the mass center.
  constexpr double shortening(int k, int l) const { return table(2, k, l); }
  /// ∫ μ ξ G_kl.
  constexpr double shortening_moment(int k, int l) const { return table(3, k, l); }

private:
  constexpr double table(int which, int k, int l) const {
    return numbers[4 + 2 * shapes + (which * shapes + k) * shapes + l];
  }
};

/// Refers to the values at one place ξ of the shapes of a beam, which are stored as one array.
struct section_values {
  const double* numbers = nullptr;
  int shapes = 0;

  static constexpr int count(int shapes) { return 1 + 2 * shapes + shapes * shapes; }

  constexpr double xi() const { return numbers[0]; }
  constexpr double value(int k) const { return numbers[1 + k]; }          ///< φ_k
  constexpr double slope(int k) const { return numbers[1 + shapes + k]; } ///< dφ_k/dξ
  /// G_kl(ξ) = ∫ φ'_k φ'_l of bending in one direction, as in `modal_integrals`.
  constexpr double shortening(int k, int l) const { return table(k, l); }
  /// ∫ φ''_k φ'_l, from the same place, for a shape k of bending in the first direction and a shape l in the
  /// second one.
  constexpr double twist(int k, int l) const { return table(k, l); }

private:
  constexpr double table(int k, int l) const { return numbers[1 + (2 + k) * shapes + l]; }
};

} // namespace kanexpr::numeric::beams
