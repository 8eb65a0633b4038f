#pragma once

/// Evaluate and integrate many systems side by side, in SIMD vectors and on several threads.

#include <kanexpr/compiler.hpp>

#include <kanexpr/batch/batch.hpp>
#include <kanexpr/batch/many.hpp>
#include <kanexpr/batch/many_results.hpp>
#include <kanexpr/batch/rollout.hpp>
#include <kanexpr/version.hpp>
