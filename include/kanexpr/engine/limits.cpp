#include <kanexpr/symbolic/limits/limits.hpp>
