#pragma once

/// Studies on many machines, by MPI. Link kanexpr::mpi.

#include <kanexpr/ensemble.hpp>
#include <kanexpr/mpi/mpi_ranks.hpp>
