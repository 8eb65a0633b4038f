#pragma once

/// The joints in `describe/joints`, for describing mechanisms. This header does not derive anything; also
/// include `kanexpr.hpp` and, for joint loads, `reactions.hpp`.

#include <kanexpr/describe.hpp>

#include <kanexpr/describe/joints/bushing.hpp>
#include <kanexpr/describe/joints/constraints.hpp>
#include <kanexpr/describe/joints/friction_load.hpp>
#include <kanexpr/describe/joints/joints.hpp>
#include <kanexpr/describe/joints/motor.hpp>
#include <kanexpr/describe/joints/reactions.hpp>
#include <kanexpr/describe/joints/rotor.hpp>
#include <kanexpr/describe/joints/stops.hpp>

// The joints
#include <kanexpr/describe/joints/floating.hpp>
#include <kanexpr/describe/joints/lower_pairs.hpp>
#include <kanexpr/describe/joints/screw.hpp>
#include <kanexpr/describe/joints/spherical.hpp>
#include <kanexpr/describe/joints/universal.hpp>
#include <kanexpr/describe/joints/weld.hpp>
