#pragma once

/// Simulate a system with SUNDIALS, and find its operating points. Link kanexpr::simulate.

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/simulate/simulate.hpp>
