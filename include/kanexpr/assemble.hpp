#pragma once

/// Find states that satisfy the constraints of a system, and say which do not.

#include <kanexpr/compiler.hpp>

#include <kanexpr/steps/assemble.hpp>
#include <kanexpr/steps/check_independence.hpp>
#include <kanexpr/steps/least_multipliers.hpp>
#include <kanexpr/version.hpp>
