#pragma once

/// Models exported by a program to other languages and tools: `write_c`, `write_casadi`, `write_fmu`.

#include <kanexpr/symbolic.hpp>

#include <kanexpr/export/c/write_c.hpp>
#include <kanexpr/export/casadi/write_casadi.hpp>
#include <kanexpr/export/fmi/write_fmu.hpp>
