#include <kanexpr/ensemble/engine/distribution.hpp>
#include <kanexpr/ensemble/engine/runs.hpp>
