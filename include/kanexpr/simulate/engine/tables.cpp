#include <kanexpr/simulate/engine/csv.hpp>
#include <kanexpr/simulate/engine/table.hpp>
