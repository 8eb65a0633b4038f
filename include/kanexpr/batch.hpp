#pragma once

/// Evaluate and move many systems side by side, in the vectors of the processor and on several threads.

#include <kanexpr/compiler.hpp>

#include <kanexpr/batch/batch.hpp>
#include <kanexpr/batch/many.hpp>
#include <kanexpr/batch/many_results.hpp>
#include <kanexpr/batch/rollout.hpp>
#include <kanexpr/version.hpp>
