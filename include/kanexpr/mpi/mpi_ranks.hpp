#pragma once

#include <kanexpr/ensemble/crew.hpp>
#include <kanexpr/mpi/compiled_mpi.hpp>
#include <kanexpr/mpi/mpi_options.hpp>

#include <memory>
#include <string>

namespace kanexpr {

/// The processes that `mpirun` has started, which do the runs of studies together:
///
///     int main(int argc, char** argv) {
///       mpi_ranks ranks(argc, argv);
///       const ensemble<System> pendulums({ … });
///       const ensemble_results found = pendulums.run({.checkpoint = "pendulums.note"}, ranks);
///       if (!ranks.is_first()) return 0;
///       …
///     }
///
/// All of them run the same program and tell the same studies in the same order. What is found is the same as
/// on the threads of one process, to the last bit, on any number of ranks. The first rank shares out the
/// runs, does some itself, and has the results, files and checkpoint; the others have results without rows.
/// Each works on `ensemble_options::threads` threads, one unless told otherwise.
///
/// There is one object, in the thread that made it, before all else and gone last: where a rank hangs at the
/// end, it ends the program.
class mpi_ranks final : public ensembles::crew {
public:
  KANEXPR_MPI mpi_ranks(int& argc, char**& argv, const mpi_options& options = {});
  KANEXPR_MPI ~mpi_ranks() override;

  KANEXPR_MPI int rank() const;  ///< of this process, from 0
  KANEXPR_MPI int count() const; ///< how many there are
  bool is_first() const { return rank() == 0; }

  KANEXPR_MPI ensemble_results run(const ensembles::job& study, const std::string& known_by,
                                   const ensemble_options& options) override;

private:
  struct state;
  KANEXPR_MPI static std::unique_ptr<state> begin(int& argc, char**& argv, const mpi_options& options);
  std::unique_ptr<state> state_;
};

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_MPI
#include <kanexpr/mpi/engine/mpi_ranks.hpp>
#endif
