#pragma once

/// Simulate a system with SUNDIALS. Link kanexpr::simulate.

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/simulations/progress.hpp>
#include <kanexpr/simulations/simulate.hpp>
#include <kanexpr/simulations/tables/csv.hpp>
