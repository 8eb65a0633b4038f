#pragma once

/// Find the states, inputs and parameters at which a system is at rest or in steady motion. Link
/// kanexpr::simulate.

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/simulations/operating_point.hpp>
