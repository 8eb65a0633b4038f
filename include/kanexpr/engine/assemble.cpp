#include <kanexpr/runtime/engine/assemble.hpp>
#include <kanexpr/runtime/engine/base_parameters.hpp>
