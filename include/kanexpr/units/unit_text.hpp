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

struct symbol {
  unit of{};
  std::string_view called{};
};

inline constexpr symbol base_symbols[base_units]{{kilogram, "kg"}, {meter, "m"},   {second, "s"},
                                                 {ampere, "A"},    {kelvin, "K"},  {mole, "mol"},
                                                 {candela, "cd"},  {radian, "rad"}};

/// Named units that are written by their own symbols. Torques and energies share a unit, which is written N
/// m.
inline constexpr symbol named[]{{newton, "N"}, {watt, "W"},  {pascal, "Pa"}, {volt, "V"}, {ohm, "Ohm"},
                                {farad, "F"},  {henry, "H"}, {coulomb, "C"}, {tesla, "T"}};

/// Units that are written as products or quotients with named units.
struct product {
  unit of{};
  symbol above{}, below{};
};
inline constexpr product products[]{
    {newton * second / meter, {newton, "N"}, {}},          // damping
    {newton * meter * second / radian, {newton, "N"}, {}}, // torsional damping
    {newton * second / radian, {newton, "N"}, {}},
    {newton / second, {newton, "N"}, {}},
    {newton * radian / second, {newton, "N"}, {}},
    {newton / ampere, {newton, "N"}, {}},
    {newton * meter / ampere, {newton, "N"}, {}},
    {newton / volt, {newton, "N"}, {volt, "V"}}, // gains of actuators and their inverse
    {volt / newton, {volt, "V"}, {newton, "N"}},
    {radian / volt, {}, {volt, "V"}},
    {radian / second / volt, {}, {volt, "V"}},
    {meter / volt, {}, {volt, "V"}},
    {meter / second / volt, {}, {volt, "V"}},
    {volt * second / radian, {volt, "V"}, {}}, // the constant of a motor
    {volt / radian, {volt, "V"}, {}},          // gains of a controller
    {volt / radian / second, {volt, "V"}, {}},
    {volt / meter, {volt, "V"}, {}},
    {volt / meter / second, {volt, "V"}, {}},
    {volt * second / meter, {volt, "V"}, {}},
    {watt / kelvin, {watt, "W"}, {}},
    {watt / meter / kelvin, {watt, "W"}, {}},
    {pascal * second, {pascal, "Pa"}, {}},
};

/// A unit with the named units in its text; the unit 1 and no symbol if there are none. Forces times lengths,
/// angles and powers of them are written with the newton.
constexpr product product_of(const unit& u) {
  for (const product& p : products)
    if (p.of == u) return p;
  if (u[base_unit::kilogram] == unit::parts && u[base_unit::second] == -2 * unit::parts)
    return {u, {newton, "N"}, {}};
  return {u, {}, {}};
}

/// Writes the factors of a unit one after the other.
class unit_writer {
public:
  constexpr explicit unit_writer(spelling how) : how_(how) {}

  constexpr base::name written(const unit& u) {
    for (const symbol& s : named)
      if (s.of == u) return around(sign_of(s));
    const product named_in = product_of(u);
    const unit rest = u / named_in.above.of * named_in.below.of;
    if (!named_in.above.called.empty()) put(named_in.above.called);
    for (int i = 0; i < base_units; ++i) factor(i, rest[base_unit_at(i)]);
    int below = named_in.below.called.empty() ? 0 : 1;
    for (int i = 0; i < base_units; ++i) below += rest[base_unit_at(i)] < 0 ? 1 : 0;
    if (is_first_) text_.append("1");
    if (below > 0) text_.append(below > 1 ? "/(" : "/");
    is_first_ = true;
    if (!named_in.below.called.empty()) put(named_in.below.called);
    for (const int i : {7, 0, 1, 2, 3, 4, 5, 6}) factor(i, -rest[base_unit_at(i)]);
    if (below > 1) text_.append(")");
    return around(text_.view());
  }

private:
  constexpr std::string_view sign_of(const symbol& s) const {
    if (s.called != "Ohm" || how_ == spelling::plain || how_ == spelling::message) return s.called;
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
    constexpr std::string_view high[]{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
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
