#pragma once

/// Export models from a program as FMUs for simulation tools: `write_fmu`. Link kanexpr::fmi.

#include <kanexpr/symbolic.hpp>

#include <kanexpr/exporting/fmi/write_fmu.hpp>
