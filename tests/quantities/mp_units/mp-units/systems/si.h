// The part of mp-units 2 that kanexpr and its test use, with the same names and meanings, for machines
// without it.
#pragma once

#include <numbers>

namespace mp_units {

struct powers {
  int kg = 0, m = 0, s = 0, A = 0, K = 0, mol = 0, cd = 0; ///< an angle is a number
  bool operator==(const powers&) const = default;
};

/// A unit: powers of base units, and its ratio to the coherent unit, in which it is measured.
template <powers dimension, double ratio>
struct unit {};

inline constexpr unit<powers{}, 1.> one{};

template <powers a, double by_a, powers b, double by_b>
constexpr auto operator*(unit<a, by_a>, unit<b, by_b>) {
  return unit<powers{a.kg + b.kg, a.m + b.m, a.s + b.s, a.A + b.A, a.K + b.K, a.mol + b.mol, a.cd + b.cd},
              by_a * by_b>{};
}
template <powers a, double by_a, powers b, double by_b>
constexpr auto operator/(unit<a, by_a>, unit<b, by_b>) {
  return unit<powers{a.kg - b.kg, a.m - b.m, a.s - b.s, a.A - b.A, a.K - b.K, a.mol - b.mol, a.cd - b.cd},
              by_a / by_b>{};
}

template <int numerator, int denominator = 1, powers of, double ratio>
  requires(numerator > 0 && denominator == 1)
constexpr auto pow(unit<of, ratio> base) {
  if constexpr (numerator == 1)
    return base;
  else
    return base * pow<numerator - 1>(base);
}

template <auto reference, class Number = double>
class quantity;

template <powers dimension, double ratio, unit<dimension, ratio> reference, class Number>
class quantity<reference, Number> {
public:
  constexpr quantity(Number value, unit<dimension, ratio>) : value_(value) {}
  template <double other, unit<dimension, other> from, class Given>
  constexpr quantity(const quantity<from, Given>& q) : value_(q.numerical_value_in(reference)) {}

  template <double other>
  constexpr Number numerical_value_in(unit<dimension, other>) const {
    return static_cast<Number>(value_ * (ratio / other));
  }
  constexpr auto operator*(double by) const {
    return quantity<reference, double>(static_cast<double>(value_) * by, reference);
  }

private:
  Number value_;
};

template <class Number, powers dimension, double ratio>
constexpr auto operator*(Number value, unit<dimension, ratio> in) {
  return quantity<unit<dimension, ratio>{}, Number>(value, in);
}

namespace si {

inline constexpr unit<powers{.kg = 1}, 1.> kilogram{};
inline constexpr unit<powers{.kg = 1}, 1e-3> gram{};
inline constexpr unit<powers{.m = 1}, 1.> metre{};
inline constexpr unit<powers{.s = 1}, 1.> second{};
inline constexpr unit<powers{.A = 1}, 1.> ampere{};
inline constexpr unit<powers{.K = 1}, 1.> kelvin{};
inline constexpr unit<powers{.mol = 1}, 1.> mole{};
inline constexpr unit<powers{.cd = 1}, 1.> candela{};
inline constexpr unit<powers{}, 1.> radian{};
inline constexpr unit<powers{}, std::numbers::pi / 180> degree{};
inline constexpr auto newton = kilogram * metre / pow<2>(second);
inline constexpr auto joule = newton * metre;

template <auto of>
inline constexpr auto centi = unit<powers{}, 1e-2>{} * of;

} // namespace si

} // namespace mp_units
