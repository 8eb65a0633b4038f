#pragma once

#include <kanexpr/units/unit.hpp>

#include <kanexpr/base/letters_aside.hpp>

/// The coherent units of the SI that have names, for `using namespace kanexpr::units::si;`. All others are
/// products and powers: `newton*meter/radian`, `meter/pow<2>(second)`. Prefixes and units with a factor, such
/// as the millimeter or the degree, are not provided: a model computes in coherent units.
namespace kanexpr::units::si {

using units::dimensionless, units::pow;

inline constexpr unit kilogram = only(base_unit::kilogram);
inline constexpr unit meter = only(base_unit::meter);
inline constexpr unit second = only(base_unit::second);
inline constexpr unit ampere = only(base_unit::ampere);
inline constexpr unit kelvin = only(base_unit::kelvin);
inline constexpr unit mole = only(base_unit::mole);
inline constexpr unit candela = only(base_unit::candela);
inline constexpr unit radian = only(base_unit::radian);

inline constexpr unit hertz = dimensionless / second;
inline constexpr unit newton = kilogram * meter / pow<2>(second);
inline constexpr unit pascal = newton / pow<2>(meter);
inline constexpr unit joule = newton * meter;
inline constexpr unit watt = joule / second;
inline constexpr unit coulomb = ampere * second;
inline constexpr unit volt = watt / ampere;
inline constexpr unit farad = coulomb / volt;
inline constexpr unit ohm = volt / ampere;
inline constexpr unit siemens = ampere / volt;
inline constexpr unit weber = volt * second;
inline constexpr unit tesla = weber / pow<2>(meter);
inline constexpr unit henry = weber / ampere;

} // namespace kanexpr::units::si

#include <kanexpr/base/letters_back.hpp>
