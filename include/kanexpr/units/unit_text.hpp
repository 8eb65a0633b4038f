#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

#include <kanexpr/base/letters_aside.hpp>

namespace kanexpr::units {

/// How a unit is written.
enum class spelling : unsigned char {
  printed, ///< kg m/s², N m/(rad s), 1
  message, ///< kg m/s^2, in which compilers show every letter
  plain,   ///< ASCII, for C and FMI: kg.m/s2, N.m/(rad.s), 1
  latex,   ///< for an equation: \mathrm{kg\,m/s^{2}}
};

namespace detail {

using namespace si;

/// A unit and its symbol, in an array, which costs the compiler less than a string of any length.
struct symbol {
  unit of{};
  char called[4]{};
};

inline constexpr symbol base_symbols[base_units]{{kilogram, "kg"}, {meter, "m"},   {second, "s"},
                                                 {ampere, "A"},    {kelvin, "K"},  {mole, "mol"},
                                                 {candela, "cd"},  {radian, "rad"}};

/// Named units that are written by their own symbols. Torques and energies share a unit, which is written N
/// m.
inline constexpr symbol named[]{{newton, "N"}, {watt, "W"},  {pascal, "Pa"}, {volt, "V"}, {ohm, "Ohm"},
                                {farad, "F"},  {henry, "H"}, {coulomb, "C"}, {tesla, "T"}};

/// Units that are written as products or quotients of named units and another one.
struct product {
  char above, below; ///< the first letters of the named units, or 0
  unit rest;
};
inline constexpr product products[]{
    {'N', 0, second / meter},         // damping
    {'N', 0, meter* second / radian}, // torsional damping
    {'N', 0, second / radian},
    {'N', 0, hertz},
    {'N', 0, radian / second},
    {'N', 0, dimensionless / ampere},
    {'N', 0, meter / ampere},
    {'N', 'V', dimensionless}, // gains of actuators and their inverse
    {'V', 'N', dimensionless},
    {0, 'V', radian},
    {0, 'V', radian / second},
    {0, 'V', meter},
    {0, 'V', meter / second},
    {'V', 0, second / radian},        // the constant of a motor
    {'V', 0, dimensionless / radian}, // gains of a controller
    {'V', 0, hertz / radian},
    {'V', 0, dimensionless / meter},
    {'V', 0, hertz / meter},
    {'V', 0, second / meter},
    {'W', 0, dimensionless / kelvin},
    {'W', 0, dimensionless / meter / kelvin},
    {'P', 0, second},
};

/// The named unit whose symbol begins with a letter; the unit 1 and no symbol for the letter 0.
constexpr symbol named_by(char letter) {
  for (const symbol& s : named)
    if (s.called[0] == letter) return s;
  return {};
}

/// The named units in the text of a unit; each is the unit 1 without a symbol if there is none.
struct named_factors {
  symbol above{}, below{};

  constexpr unit of(const unit& rest) const { return above.of * rest / below.of; }
};

/// Returns the named units in the text of a unit. Forces times lengths, angles and powers of them are written
/// with the newton.
constexpr named_factors named_factors_of(const unit& u) {
  for (const product& p : products)
    if (const named_factors all{named_by(p.above), named_by(p.below)}; all.of(p.rest) == u) return all;
  if (u[base_unit::kilogram] == unit::parts && u[base_unit::second] == -2 * unit::parts)
    return {named[0], {}};
  return {};
}

/// Writes the factors of a unit one after the other.
class unit_writer {
public:
  constexpr explicit unit_writer(spelling how) : how_(how) {}

  constexpr base::name written(const unit& u) {
    for (const symbol& s : named)
      if (s.of == u) return around(sign_of(s));
    const named_factors named_in = named_factors_of(u);
    const unit rest = u / named_in.above.of * named_in.below.of;
    if (named_in.above.called[0] != '\0') put(named_in.above.called);
    for (int i = 0; i < base_units; ++i) factor(i, rest[base_unit_at(i)]);
    int below = named_in.below.called[0] == '\0' ? 0 : 1;
    for (int i = 0; i < base_units; ++i) below += rest[base_unit_at(i)] < 0 ? 1 : 0;
    if (is_first_) text_.append("1");
    if (below > 0) text_.append(below > 1 ? "/(" : "/");
    is_first_ = true;
    if (named_in.below.called[0] != '\0') put(named_in.below.called);
    for (const int i : {7, 0, 1, 2, 3, 4, 5, 6}) factor(i, -rest[base_unit_at(i)]);
    if (below > 1) text_.append(")");
    return around(text_.view());
  }

private:
  constexpr std::string_view sign_of(const symbol& s) const {
    if (s.called[0] != 'O' || how_ == spelling::plain || how_ == spelling::message) return s.called;
    return how_ == spelling::latex ? "\\Omega" : "Ω";
  }
  constexpr base::name around(std::string_view text) const {
    base::name whole;
    if (how_ == spelling::latex) whole.append("\\mathrm{");
    whole.append(text);
    if (how_ == spelling::latex) whole.append("}");
    return whole;
  }

  constexpr void put(std::string_view symbol) {
    if (!is_first_) text_.append(how_ == spelling::latex ? "\\," : how_ == spelling::plain ? "." : " ");
    is_first_ = false;
    text_.append(symbol);
  }

  constexpr void factor(int base, int power) {
    if (power <= 0) return;
    put(base_symbols[base].called);
    raise(unit::power_of(base_unit_at(base), power).exponent_of(base_unit_at(base)));
  }

  constexpr void raise(const exponent& e) {
    if (e == exponent{1, 1}) return;
    if (how_ == spelling::latex) text_.append("^{");
    if (!e.is_integer()) {
      text_.append(how_ == spelling::latex ? "" : "^(");
      text_.append(e.numerator);
      text_.append("/");
      text_.append(e.denominator);
      text_.append(how_ == spelling::latex ? "" : ")");
    } else if (how_ == spelling::printed) {
      raised(e.numerator);
    } else {
      text_.append(how_ == spelling::message ? "^" : "");
      text_.append(e.numerator);
    }
    if (how_ == spelling::latex) text_.append("}");
  }
  constexpr void raised(int digits) {
    constexpr const char* high[]{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (digits >= 10) raised(digits / 10);
    text_.append(high[digits % 10]);
  }

  spelling how_;
  base::name text_{};
  bool is_first_ = true;
};

} // namespace detail

/// Returns a unit as text: `N m/rad`, or `1` for a number. A force is written N, a torque and an energy N m.
constexpr base::name text_of(const unit& u, spelling how = spelling::printed) {
  return detail::unit_writer(how).written(u);
}

} // namespace kanexpr::units

#include <kanexpr/base/letters_back.hpp>
