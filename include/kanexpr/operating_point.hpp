#pragma once

/// Find the states, inputs and parameters at which a system rests or moves steadily. Link kanexpr::simulate.

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/simulate/operating_point.hpp>
