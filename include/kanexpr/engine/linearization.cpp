#include <kanexpr/runtime/engine/linearization.hpp>
#include <kanexpr/runtime/engine/linearization_point.hpp>
