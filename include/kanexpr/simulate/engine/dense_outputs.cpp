#include <kanexpr/simulate/engine/dense_output.hpp>
