#pragma once

/// Find states that satisfy the constraints of a system, and check states against them.

#include <kanexpr/compiler.hpp>

#include <kanexpr/steps/assemble.hpp>
#include <kanexpr/steps/check_independence.hpp>
#include <kanexpr/steps/least_multipliers.hpp>
#include <kanexpr/version.hpp>
