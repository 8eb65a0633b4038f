#pragma once

/// Simulate a system with SUNDIALS. Link kanexpr::simulate.

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/simulate/progress.hpp>
#include <kanexpr/simulate/simulate.hpp>
#include <kanexpr/simulate/tables/csv.hpp>
