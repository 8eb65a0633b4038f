#include <kanexpr/mpi/mpi_ranks.ipp>
