#pragma once

/// Integrate the equations of motion with steps of a length that is given, for use in real time.

#include <kanexpr/compiler.hpp>

#include <kanexpr/steps/fixed_step.hpp>
#include <kanexpr/steps/passing_step.hpp>
#include <kanexpr/version.hpp>
