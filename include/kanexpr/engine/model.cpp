#include <kanexpr/runtime/engine/model.hpp>
