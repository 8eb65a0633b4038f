#pragma once

/// Export models from a program to other languages and tools: `write_c`, `write_casadi`.

#include <kanexpr/symbolic.hpp>

#include <kanexpr/exporting/c/write_c.hpp>
#include <kanexpr/exporting/casadi/write_casadi.hpp>
