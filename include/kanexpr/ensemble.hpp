#pragma once

/// Many simulations of one system. Link kanexpr::ensemble.

#include <kanexpr/compiler.hpp>

#include <kanexpr/ensembles/csv_file.hpp>
#include <kanexpr/ensembles/ensemble.hpp>
#include <kanexpr/ensembles/stop_on_signal.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/simulate.hpp>
