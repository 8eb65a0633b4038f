#pragma once

/// Studies on many machines with MPI. Link kanexpr::mpi.

#include <kanexpr/ensemble.hpp>
#include <kanexpr/mpi/mpi_ranks.hpp>
