#pragma once

/// Joints for the description of mechanisms, each kind in a separate file. This header does not derive
/// anything; also include `kanexpr.hpp` and, for joint loads, `reactions.hpp`.

#include <kanexpr/describe.hpp>

#include <kanexpr/joints/constraints.hpp>
#include <kanexpr/joints/ground.hpp>
#include <kanexpr/joints/joints.hpp>
#include <kanexpr/joints/motor.hpp>
#include <kanexpr/joints/reactions.hpp>

// The joints
#include <kanexpr/joints/cylindrical.hpp>
#include <kanexpr/joints/floating.hpp>
#include <kanexpr/joints/pin.hpp>
#include <kanexpr/joints/planar.hpp>
#include <kanexpr/joints/prismatic.hpp>
#include <kanexpr/joints/screw.hpp>
#include <kanexpr/joints/spherical.hpp>
#include <kanexpr/joints/universal.hpp>
#include <kanexpr/joints/weld.hpp>
