#pragma once

/// Integrate the equations of motion with fixed-length steps, for real-time use.

#include <kanexpr/compiler.hpp>

#include <kanexpr/steps/fixed_step.hpp>
#include <kanexpr/steps/passing_step.hpp>
#include <kanexpr/version.hpp>
