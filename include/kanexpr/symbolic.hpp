#pragma once

/// Everything of kanexpr.hpp, and derivation while the program runs: results as expressions, to print and to
/// evaluate.

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/model.hpp>
