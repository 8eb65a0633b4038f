#include <kanexpr/simulate/trim_search.hpp>
