#pragma once

/// Everything in kanexpr.hpp, plus derivation at run time: results as expressions, to print and to evaluate.

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/model.hpp>
