#include <kanexpr/ensemble/engine/csv_file.hpp>
#include <kanexpr/ensemble/engine/held_file.hpp>
#include <kanexpr/ensemble/engine/lock_beside.hpp>
#include <kanexpr/ensemble/engine/sum_of_bytes.hpp>
