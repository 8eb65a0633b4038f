#pragma once

#include <kanexpr/ensembles/content_hash.hpp>
#include <kanexpr/mpi/first_rank.ipp>
#include <kanexpr/mpi/mpi_ranks.hpp>
#include <kanexpr/mpi/other_rank.ipp>

#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace kanexpr {

struct mpi_ranks::state {
  std::optional<mpi::channel> messages{};
  std::set<int> absent{}; ///< known to the first rank
};

KANEXPR_MPI mpi_ranks::mpi_ranks(int& argc, char**& argv) : state_(std::make_unique<state>()) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  if (provided < MPI_THREAD_SERIALIZED)
    throw std::runtime_error("this MPI does not support calls from several threads (MPI_THREAD_SERIALIZED)");
  state_->messages.emplace();
}

KANEXPR_MPI mpi_ranks::~mpi_ranks() {
  try {
    if (is_first())
      mpi::first_rank(*state_->messages, state_->absent, 0).serve_without_study();
    else
      state_->messages->send(0, mpi::to_first, mpi::report{.wants = mpi::request::leave});
  } catch (const std::exception&) { // ranks that cannot be reached would make MPI_Finalize wait for ever
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  }
  state_->messages.reset();
  MPI_Finalize();
}

KANEXPR_MPI int mpi_ranks::rank() const { return state_->messages->rank(); }
KANEXPR_MPI int mpi_ranks::count() const { return state_->messages->ranks(); }

KANEXPR_MPI ensemble_results mpi_ranks::run(const ensembles::study_interface& study,
                                            const std::string& identity, const ensemble_options& options) {
  const std::uint64_t hash = ensembles::content_hash(ensembles::identity_of(study.layout(), identity));
  if (is_first())
    return mpi::first_rank(*state_->messages, state_->absent, hash).run(study, identity, options);
  mpi::summary all =
      mpi::other_rank(*state_->messages, hash).run(study, options.threads > 0 ? options.threads : 1);
  ensemble_results found;
  found.planned = study.layout().runs;
  found.done = all.done, found.failed = all.failed, found.failure = std::move(all.failure);
  return found;
}

} // namespace kanexpr
