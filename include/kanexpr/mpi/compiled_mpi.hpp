#pragma once

#include <kanexpr/base/one_way.hpp>

/// What runs on ranks is compiled by every file that uses it, or the library kanexpr::mpi_engine holds it:
/// then KANEXPR_COMPILED_MPI is defined wherever the headers are included.
#if defined KANEXPR_COMPILED_MPI
#define KANEXPR_MPI
KANEXPR_ONE_WAY("KANEXPR_COMPILED_MPI", "1");
#else
#define KANEXPR_MPI inline
KANEXPR_ONE_WAY("KANEXPR_COMPILED_MPI", "2");
#endif
