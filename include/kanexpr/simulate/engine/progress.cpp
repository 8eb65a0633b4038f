#include <kanexpr/simulate/engine/progress.hpp>
