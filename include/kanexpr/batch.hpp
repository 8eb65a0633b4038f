#pragma once

/// Evaluate and integrate many systems side by side, in SIMD vectors and on several threads.

#include <kanexpr/compiler.hpp>

#include <kanexpr/batches/batch.hpp>
#include <kanexpr/batches/many.hpp>
#include <kanexpr/batches/many_results.hpp>
#include <kanexpr/batches/rollout.hpp>
#include <kanexpr/version.hpp>
