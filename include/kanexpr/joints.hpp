#pragma once

/// Joints for the description of mechanisms, each kind in a separate file. This header does not derive
/// anything; also include `kanexpr.hpp` and, for joint loads, `reactions.hpp`.

#include <kanexpr/describe.hpp>

#include <kanexpr/describe/joints/constraints.hpp>
#include <kanexpr/describe/joints/ground.hpp>
#include <kanexpr/describe/joints/joints.hpp>
#include <kanexpr/describe/joints/motor.hpp>
#include <kanexpr/describe/joints/reactions.hpp>

// The joints
#include <kanexpr/describe/joints/cylindrical.hpp>
#include <kanexpr/describe/joints/floating.hpp>
#include <kanexpr/describe/joints/pin.hpp>
#include <kanexpr/describe/joints/planar.hpp>
#include <kanexpr/describe/joints/prismatic.hpp>
#include <kanexpr/describe/joints/screw.hpp>
#include <kanexpr/describe/joints/spherical.hpp>
#include <kanexpr/describe/joints/universal.hpp>
#include <kanexpr/describe/joints/weld.hpp>
