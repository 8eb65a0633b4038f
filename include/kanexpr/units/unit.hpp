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
/// a template argument. Functions that form one write all powers: g++ 12 considers two template arguments
/// equal if their arrays differ only in the positions of the elements that were written.
struct unit {
  static constexpr int parts = 60;
  std::int16_t powers[base_units]{}; ///< by base_unit

  constexpr bool operator==(const unit&) const = default;
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    for (auto& power : self.powers) visit(power);
  }

  constexpr int operator[](base_unit of) const { return powers[static_cast<int>(of)]; }
  constexpr exponent exponent_of(base_unit of) const {
    int numerator = (*this)[of], denominator = parts;
    for (const int factor : {2, 2, 3, 5})
      if (numerator % factor == 0) numerator /= factor, denominator /= factor;
    return {numerator, denominator};
  }

  friend constexpr unit operator*(unit a, const unit& b) { return a.times(b, 1); }
  friend constexpr unit operator/(unit a, const unit& b) { return a.times(b, -1); }

private:
  constexpr unit times(const unit& other, int power) const {
    unit product{};
    for (int i = 0; i < base_units; ++i)
      product.powers[i] = static_cast<std::int16_t>(powers[i] + power * other.powers[i]);
    return product;
  }
};

/// The unit of the numbers, 1.
inline constexpr unit dimensionless = unit() * unit();

constexpr unit only(base_unit of) {
  unit u{};
  for (int i = 0; i < base_units; ++i)
    u.powers[i] = static_cast<std::int16_t>(i == static_cast<int>(of) ? unit::parts : 0);
  return u;
}

/// Whether a unit can be raised to the power numerator/denominator exactly.
constexpr bool has_power(const unit& of, std::int64_t numerator, std::int64_t denominator) {
  constexpr std::int64_t most = 32767;
  if (denominator == 0) return false;
  for (const std::int16_t power : of.powers) {
    const std::int64_t raised = power * numerator;
    if (raised % denominator != 0 || raised / denominator > most || raised / denominator < -most)
      return false;
  }
  return true;
}

/// The power numerator/denominator of a unit. Requires `has_power`.
constexpr unit power(const unit& of, std::int64_t numerator, std::int64_t denominator = 1) {
  unit raised{};
  for (int i = 0; i < base_units; ++i)
    raised.powers[i] = static_cast<std::int16_t>(of.powers[i] * numerator / denominator);
  return raised;
}

/// A power of a unit: `pow<2>(second)`, `pow<1, 2>(meter)`.
template <int numerator, int denominator = 1>
constexpr unit pow(const unit& of) {
  static_assert(denominator != 0 && unit::parts % denominator == 0,
                "the power of a unit must be a multiple of 1/60");
  return power(of, numerator, denominator);
}

/// The same unit without its powers of the radian.
constexpr unit without_angle(const unit& of) {
  unit rest{};
  for (int i = 0; i < base_units; ++i)
    rest.powers[i] = static_cast<std::int16_t>(i == static_cast<int>(base_unit::radian) ? 0 : of.powers[i]);
  return rest;
}

/// Whether quantities of two units can be added and compared. An angle fits a number: ω × r is a velocity.
constexpr bool fits(const unit& a, const unit& b) { return without_angle(a) == without_angle(b); }

} // namespace kanexpr::units
