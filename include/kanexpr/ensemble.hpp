#pragma once

/// Many simulations of one system. Link kanexpr::ensemble.

#include <kanexpr/compiler.hpp>

#include <kanexpr/ensemble/csv_file.hpp>
#include <kanexpr/ensemble/ensemble.hpp>
#include <kanexpr/ensemble/stop_on_signal.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/simulate.hpp>
