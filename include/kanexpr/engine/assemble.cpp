#include <kanexpr/runtime/engine/assemble.hpp>
