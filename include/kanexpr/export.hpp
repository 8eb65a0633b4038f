#pragma once

/// Models exported by a program to other languages and tools: `write_c`, `write_casadi`, `write_fmu`.

#include <kanexpr/symbolic.hpp>

#include <kanexpr/export/write_c.hpp>
#include <kanexpr/export/write_casadi.hpp>
#include <kanexpr/export/write_fmu.hpp>
