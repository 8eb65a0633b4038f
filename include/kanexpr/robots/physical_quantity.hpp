#pragma once

#include <kanexpr/units/implied.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr::robots {

/// The quantities of a robot. URDF and SDF define their units: meters, kilograms, seconds and radians.
enum class physical_quantity : unsigned char {
  ratio,
  angle,
  angular_velocity,
  length,
  velocity,
  acceleration,
  mass,
  moment_of_inertia,
  force,
  torque,
  damping,
  angular_damping,
  angle_per_length,
  length_per_angle,
};

namespace detail {

struct quantity_row {
  physical_quantity is{};
  std::string_view called{}; ///< in `units::implied`
  units::implied_unit unit{};
};

using enum physical_quantity;

inline constexpr quantity_row quantities[]{
    {ratio, "ratio", units::implied::ratio},
    {angle, "angle", units::implied::angle},
    {angular_velocity, "angular_velocity", units::implied::angular_velocity},
    {length, "length", units::implied::length},
    {velocity, "velocity", units::implied::velocity},
    {acceleration, "acceleration", units::implied::acceleration},
    {mass, "mass", units::implied::mass},
    {moment_of_inertia, "moment_of_inertia", units::implied::moment_of_inertia},
    {force, "force", units::implied::force},
    {torque, "torque", units::implied::torque},
    {damping, "damping", units::implied::damping},
    {angular_damping, "angular_damping", units::implied::angular_damping},
    {angle_per_length, "angle_per_length", units::implied::angle_per_length},
    {length_per_angle, "length_per_angle", units::implied::length_per_angle},
};

static_assert([] {
  int next = 0;
  for (const quantity_row& row : quantities)
    if (static_cast<int>(row.is) != next++) return false;
  return true;
}());

} // namespace detail

/// The name of the unit of a quantity in `units::implied`.
constexpr std::string_view name_of(physical_quantity q) {
  return detail::quantities[static_cast<int>(q)].called;
}
constexpr const units::unit& unit_of(physical_quantity q) {
  return detail::quantities[static_cast<int>(q)].unit.of;
}

} // namespace kanexpr::robots
