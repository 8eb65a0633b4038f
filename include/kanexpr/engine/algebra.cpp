#include <kanexpr/symbolic/algebra/compare.hpp>
#include <kanexpr/symbolic/algebra/expand.hpp>
#include <kanexpr/symbolic/algebra/simplify.hpp>
