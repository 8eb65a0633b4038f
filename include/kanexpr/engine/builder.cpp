#include <kanexpr/runtime/engine/builder.hpp>
