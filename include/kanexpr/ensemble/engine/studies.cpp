#include <kanexpr/ensemble/engine/checkpoint.hpp>
#include <kanexpr/ensemble/engine/collector.hpp>
#include <kanexpr/ensemble/engine/on_threads.hpp>
