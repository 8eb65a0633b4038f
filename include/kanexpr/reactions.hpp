#pragma once

/// The forces and torques that joints transmit.

#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

#include <kanexpr/compiled/reactions.hpp>
