#pragma once

#include <kanexpr/ensembles/ensemble_options.hpp>
#include <kanexpr/ensembles/ensemble_results.hpp>
#include <kanexpr/ensembles/study_interface.hpp>
#include <kanexpr/mpi/compiled_mpi.hpp>

#include <memory>

namespace kanexpr {

/// The processes that `mpirun` has started, which perform the runs of studies together:
///
///     int main(int argc, char** argv) {
///       mpi_ranks ranks(argc, argv);
///       const ensemble<System> pendulums({ … });
///       const ensemble_results found = pendulums.run({.checkpoint = "pendulums.checkpoint"}, ranks);
///       if (!ranks.is_first()) return 0;
///       …
///     }
///
/// Every rank must construct the same studies in the same order. For any number of ranks, the results are the
/// same to the last bit as those of one process. The first rank distributes the runs and performs some of
/// them; only this rank has rows, files and the checkpoint. Each rank uses `ensemble_options::threads`
/// threads, by default one.
///
/// A program creates one such object at its start. Its constructor initializes MPI, and its destructor
/// finalizes it.
class mpi_ranks {
public:
  KANEXPR_MPI mpi_ranks(int& argc, char**& argv);
  mpi_ranks(const mpi_ranks&) = delete;
  mpi_ranks& operator=(const mpi_ranks&) = delete;
  KANEXPR_MPI ~mpi_ranks();

  KANEXPR_MPI int rank() const;  ///< the number of this process, from 0
  KANEXPR_MPI int count() const; ///< the number of ranks
  bool is_first() const { return rank() == 0; }

  /// Performs a study, as `ensemble::run` does.
  KANEXPR_MPI ensemble_results run(const ensembles::study_interface& study, const ensemble_options& options);

private:
  struct state;
  std::unique_ptr<state> state_;
};

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_MPI
#include <kanexpr/mpi/compiled_mpi.hpp>
#include <kanexpr/mpi/mpi_ranks.ipp>
#endif
