#include <kanexpr/mpi/engine/mpi_ranks.hpp>
