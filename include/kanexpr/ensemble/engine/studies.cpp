#include <kanexpr/ensemble/engine/checkpoint.hpp>
#include <kanexpr/ensemble/engine/collector.hpp>
#include <kanexpr/ensemble/engine/ensemble_results.hpp>
#include <kanexpr/ensemble/engine/on_threads.hpp>
#include <kanexpr/ensemble/engine/stop_on_signal.hpp>
