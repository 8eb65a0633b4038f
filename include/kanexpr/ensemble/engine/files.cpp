#include <kanexpr/ensemble/engine/csv_file.hpp>
