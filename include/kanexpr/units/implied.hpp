#pragma once

#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

/// The units of the quantities of a robot, which follow from the definition of its file format.
namespace kanexpr::units::implied {

inline constexpr implied_unit ratio{si::dimensionless};
inline constexpr implied_unit angle{si::radian};
inline constexpr implied_unit angular_velocity{si::radian / si::second};
inline constexpr implied_unit length{si::meter};
inline constexpr implied_unit velocity{si::meter / si::second};
inline constexpr implied_unit acceleration{si::meter / pow<2>(si::second)};
inline constexpr implied_unit mass{si::kilogram};
inline constexpr implied_unit moment_of_inertia{si::kilogram * pow<2>(si::meter)};
inline constexpr implied_unit force{si::newton};
inline constexpr implied_unit torque{si::newton * si::meter};
inline constexpr implied_unit damping{si::newton * si::second / si::meter};
inline constexpr implied_unit angular_damping{si::newton * si::meter * si::second / si::radian};
/// The advance of an angle per length and of a length per angle, of joints that follow others.
inline constexpr implied_unit angle_per_length{si::radian / si::meter};
inline constexpr implied_unit length_per_angle{si::meter / si::radian};

} // namespace kanexpr::units::implied
