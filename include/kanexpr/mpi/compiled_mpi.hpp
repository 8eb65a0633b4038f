#pragma once

#include <kanexpr/base/one_way.hpp>

/// The code for MPI is compiled in every file that uses it, or only once, in the library kanexpr::mpi_engine,
/// which defines KANEXPR_COMPILED_MPI for all its users.
#if defined KANEXPR_COMPILED_MPI
#define KANEXPR_MPI
KANEXPR_ONE_WAY("KANEXPR_COMPILED_MPI", "1");
#else
#define KANEXPR_MPI inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_MPI", "2");
#endif
