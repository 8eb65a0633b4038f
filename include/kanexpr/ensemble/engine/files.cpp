#include <kanexpr/ensemble/engine/csv_file.hpp>
#include <kanexpr/ensemble/engine/held_file.hpp>
