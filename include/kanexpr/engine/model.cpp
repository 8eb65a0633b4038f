#include <kanexpr/runtime/engine/model.hpp>
#include <kanexpr/runtime/engine/staged_derivation.hpp>
