#pragma once

#include <cstdint>
#include <initializer_list>

namespace kanexpr::units {

/// The base units: those of the SI, and the radian, which is kept apart from 1 so that angles can be shown.
enum class base_unit : unsigned char { kilogram, meter, second, ampere, kelvin, mole, candela, radian };

inline constexpr int base_units = 8;

/// A power of a base unit, reduced: 1/2 for a square root.
struct exponent {
  int numerator = 0;
  int denominator = 1;

  constexpr bool operator==(const exponent&) const = default;
  constexpr bool is_integer() const { return denominator == 1; }
};

/// A coherent unit of the SI: a product of powers of base units without a factor, such as kg m/s².
///
/// Powers are stored in sixtieths, so that halves to sixths and tenths are exact; a value of this type can be
/// a template argument. Four powers at a time are the digits of an integer with the base 2¹⁶, because g++ 12
/// confuses template arguments that contain arrays with zeros.
struct unit {
  static constexpr int parts = 60;
  std::int64_t kg_m_s_a = 0;
  std::int64_t k_mol_cd_rad = 0;

  constexpr bool operator==(const unit&) const = default;

  /// The power of a base unit, in sixtieths.
  constexpr int operator[](base_unit of) const {
    const int place = static_cast<int>(of);
    std::int64_t digits = place < 4 ? kg_m_s_a : k_mol_cd_rad;
    for (int below = place % 4; below > 0; --below) digits = (digits - below_power(digit, digits)) / digit;
    return static_cast<int>(below_power(digit, digits));
  }
  constexpr exponent exponent_of(base_unit of) const {
    int numerator = (*this)[of], denominator = parts;
    for (const int factor : {2, 2, 3, 5})
      if (numerator % factor == 0) numerator /= factor, denominator /= factor;
    return {numerator, denominator};
  }

  friend constexpr unit operator*(const unit& a, const unit& b) {
    return {a.kg_m_s_a + b.kg_m_s_a, a.k_mol_cd_rad + b.k_mol_cd_rad};
  }
  friend constexpr unit operator/(const unit& a, const unit& b) {
    return {a.kg_m_s_a - b.kg_m_s_a, a.k_mol_cd_rad - b.k_mol_cd_rad};
  }

  /// The same unit without its powers of the radian, whose digit is the highest.
  constexpr unit without_angle() const {
    return {kg_m_s_a, below_power(digit * digit * digit, k_mol_cd_rad)};
  }

  /// A power of one base unit, in sixtieths.
  static constexpr unit power_of(base_unit of, std::int64_t power) {
    const int place = static_cast<int>(of);
    for (int below = place % 4; below > 0; --below) power *= digit;
    return place < 4 ? unit{power, 0} : unit{0, power};
  }

  /// Whether all powers are between −273 and 273, so that products of a few units are exact.
  constexpr bool is_in_range() const {
    const auto fits = [](std::int64_t digits) {
      return ((static_cast<std::uint64_t>(digits) + 0x4000400040004000U) & 0x8000800080008000U) == 0;
    };
    return fits(kg_m_s_a) && fits(k_mol_cd_rad);
  }
  /// Represents all units that cannot be stored; it stays out of range in products.
  static constexpr unit out_of_range() { return {0x6000600060006000, 0x6000600060006000}; }

private:
  static constexpr std::int64_t digit = 1 << 16;

  /// The part of an integer that its digits below a power of the base represent.
  static constexpr std::int64_t below_power(std::int64_t power, std::int64_t digits) {
    const std::int64_t low = digits % power;
    return low >= power / 2 ? low - power : low < -power / 2 ? low + power : low;
  }
};

/// A unit that follows from the definition of a quantity, for example in a file of a robot. It is shown like
/// one that the model states, but a model is not checked because of it.
struct implied_unit {
  unit of{};

  constexpr bool operator==(const implied_unit&) const = default;
};

constexpr base_unit base_unit_at(int place) { return static_cast<base_unit>(place); }

/// The unit of the numbers, 1.
inline constexpr unit dimensionless{};

constexpr unit only(base_unit of) { return unit::power_of(of, unit::parts); }

/// Whether a unit can be raised to the power numerator/denominator exactly.
constexpr bool has_power(const unit& of, std::int64_t numerator, std::int64_t denominator) {
  constexpr std::int64_t most = 32767;
  if (denominator == 0) return false;
  if (numerator == denominator || numerator == -denominator || of == dimensionless) return true;
  for (int i = 0; i < base_units; ++i) {
    const std::int64_t raised = of[base_unit_at(i)] * numerator;
    if (raised % denominator != 0 || raised / denominator > most || raised / denominator < -most)
      return false;
  }
  return true;
}

/// The power numerator/denominator of a unit. Requires `has_power`.
constexpr unit power(const unit& of, std::int64_t numerator, std::int64_t denominator = 1) {
  if (numerator % denominator == 0) { // all digits at a time
    const std::int64_t whole = numerator / denominator;
    return {of.kg_m_s_a * whole, of.k_mol_cd_rad * whole};
  }
  unit raised{};
  for (int i = 0; i < base_units; ++i)
    raised = raised * unit::power_of(base_unit_at(i), of[base_unit_at(i)] * numerator / denominator);
  return raised;
}

/// A power of a unit: `pow<2>(second)`, `pow<1, 2>(meter)`. A symbol with a unit that cannot be represented
/// is a mistake in a model.
template <int numerator, int denominator = 1>
constexpr unit pow(const unit& of) {
  static_assert(denominator != 0 && unit::parts % denominator == 0,
                "the power of a unit must be a multiple of 1/60");
  if (!has_power(of, numerator, denominator)) return unit::out_of_range();
  const unit raised = power(of, numerator, denominator);
  return raised.is_in_range() ? raised : unit::out_of_range();
}

/// The same unit without its powers of the radian.
constexpr unit without_angle(const unit& of) { return of.without_angle(); }

/// Whether quantities of two units can be added and compared. An angle fits a number: ω × r is a velocity.
constexpr bool fits(const unit& a, const unit& b) { return without_angle(a) == without_angle(b); }

} // namespace kanexpr::units
