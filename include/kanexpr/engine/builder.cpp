#include <kanexpr/runtime/engine/builder.hpp>
#include <kanexpr/runtime/engine/builder_constraints.hpp>
#include <kanexpr/runtime/engine/builder_loads.hpp>
