#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace {

using namespace kanexpr::units;
using namespace kanexpr::units::si;

std::string written(const unit& u, spelling how = spelling::printed) {
  return std::string(text_of(u, how).view());
}

TEST(unit, is_a_product_of_powers) {
  static_assert(newton * meter == joule && joule / second == watt && volt * ampere == watt);
  static_assert(pow<2>(second) == second * second && pow<-1>(second) == hertz);
  static_assert(pow<2>(pow<1, 2>(kilogram)) == kilogram && pow<3>(pow<1, 3>(meter)) == meter);
  static_assert((newton / meter)[base_unit::second] == -2 * unit::parts);
  static_assert(pow<3, 2>(meter).exponent_of(base_unit::meter) == exponent{3, 2});
  static_assert(dimensionless.exponent_of(base_unit::meter) == exponent{0, 1});
  static_assert((dimensionless / pow<2>(second)).exponent_of(base_unit::second) == exponent{-2, 1});
}

template <unit...>
struct tagged {};
template <unit a, unit b>
constexpr bool are_same = std::is_same_v<tagged<a>, tagged<b>>;

TEST(unit, is_a_template_argument) {
  static_assert(!are_same<kilogram, meter> && !are_same<meter, second> && !are_same<second, radian>);
  static_assert(!are_same<radian, dimensionless> && !are_same<meter / second, second / meter>);
  static_assert(are_same<kilogram / kilogram, dimensionless> && are_same<unit{}, dimensionless>);
  static_assert(are_same<kilogram * dimensionless, kilogram> && are_same<power(radian, 0), dimensionless>);
  static_assert(are_same<without_angle(newton * meter / radian), joule>);
}

TEST(unit, of_an_angle_fits_a_number) {
  static_assert(radian != dimensionless && fits(radian, dimensionless));
  static_assert(fits(newton * meter / radian, joule) && !fits(newton, joule));
}

TEST(unit, has_a_power_if_it_is_exact) {
  static_assert(has_power(meter, 1, 60) && !has_power(meter, 1, 7) && has_power(pow<7>(meter), 1, 7));
  static_assert(!has_power(meter, 1000, 1) && !has_power(meter, 1, 0) && has_power(dimensionless, 1, 7));
  static_assert(power(meter, 3, 2) == pow<3, 2>(meter));
  static_assert(pow<200>(meter).is_in_range() && !pow<600>(meter).is_in_range());
  static_assert(pow<-273>(second).is_in_range() && !pow<274>(second).is_in_range());
  static_assert(!pow<1, 60>(pow<1, 60>(meter)).is_in_range());
  static_assert(!(pow<600>(meter) * newton / pow<100>(second)).is_in_range());
}

TEST(unit, is_written_as_in_mechanics) {
  const struct {
    unit of;
    const char *printed, *plain;
  } all[]{
      {dimensionless, "1", "1"},
      {kilogram, "kg", "kg"},
      {newton, "N", "N"},
      {joule, "N m", "N.m"},
      {watt, "W", "W"},
      {newton / meter, "N/m", "N/m"},
      {newton * second / meter, "N s/m", "N.s/m"},
      {newton * meter / radian, "N m/rad", "N.m/rad"},
      {newton * meter * second / radian, "N m s/rad", "N.m.s/rad"},
      {newton / pow<3, 2>(meter), "N/m^(3/2)", "N/m^(3/2)"},
      {newton * pow<2>(meter), "N m²", "N.m2"},
      {radian / second, "rad/s", "rad/s"},
      {meter / pow<2>(second), "m/s²", "m/s2"},
      {kilogram * pow<2>(meter), "kg m²", "kg.m2"},
      {kilogram * meter / second, "kg m/s", "kg.m/s"},
      {kilogram * pow<2>(meter) / second, "kg m²/s", "kg.m2/s"},
      {kilogram / meter, "kg/m", "kg/m"},
      {kilogram / pow<3>(meter), "kg/m³", "kg/m3"},
      {hertz, "1/s", "1/s"},
      {volt * second / radian, "V s/rad", "V.s/rad"},
      {radian / volt / second, "rad/(V s)", "rad/(V.s)"},
      {newton / volt, "N/V", "N/V"},
      {volt / radian / second, "V/(rad s)", "V/(rad.s)"},
      {volt / newton, "V/N", "V/N"},
      {meter / second / volt, "m/(V s)", "m/(V.s)"},
      {newton * meter / ampere, "N m/A", "N.m/A"},
      {ohm, "Ω", "Ohm"},
      {henry, "H", "H"},
      {pascal * second, "Pa s", "Pa.s"},
      {watt / meter / kelvin, "W/(m K)", "W/(m.K)"},
      {pow<12>(meter) * mole, "m¹² mol", "m12.mol"},
  };
  for (const auto& each : all) {
    EXPECT_EQ(written(each.of), each.printed);
    EXPECT_EQ(written(each.of, spelling::plain), each.plain);
  }
  EXPECT_EQ(written(meter / pow<2>(second), spelling::latex), "\\mathrm{m/s^{2}}");
  EXPECT_EQ(written(pow<1, 2>(meter) * second, spelling::latex), "\\mathrm{m^{1/2}\\,s}");
}

} // namespace
