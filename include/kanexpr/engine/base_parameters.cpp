#include <kanexpr/runtime/engine/base_parameters.hpp>
