#pragma once

/// The forces and torques that joints carry.

#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

#include <kanexpr/compiled/reactions.hpp>
