#pragma once

/// What runs on ranks is compiled by every file that uses it, or the library kanexpr::mpi_engine holds it:
/// then KANEXPR_COMPILED_MPI is defined wherever the headers are included.
#if defined KANEXPR_COMPILED_MPI
#define KANEXPR_MPI
#else
#define KANEXPR_MPI inline
#endif
