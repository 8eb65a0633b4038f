#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensemble/sum_of_bytes.hpp>
#include <kanexpr/mpi/engine/first_rank.hpp>
#include <kanexpr/mpi/engine/mpi_mailbox.hpp>
#include <kanexpr/mpi/engine/other_rank.hpp>
#include <kanexpr/mpi/engine/siblings.hpp>
#include <kanexpr/mpi/engine/this_program.hpp>
#include <kanexpr/mpi/mpi_ranks.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace kanexpr {

struct mpi_ranks::state {
  explicit state(const mpi_options& told) : options(told) {
    // Who ends hanging ranks must know those of its own machine.
    char name[MPI_MAX_PROCESSOR_NAME] = {};
    int length = 0;
    MPI_Get_processor_name(name, &length);
    const std::uint64_t own[2] = {ensembles::sum_of(std::string_view(name, static_cast<std::size_t>(length))),
                                  static_cast<std::uint64_t>(::getpid())};
    processes.resize(2 * static_cast<std::size_t>(post.ranks()));
    MPI_Allgather(own, 2, MPI_UINT64_T, processes.data(), 2, MPI_UINT64_T, MPI_COMM_WORLD);
  }

  void end_lost_siblings() const {
    const auto process_of = [&](std::int64_t rank) { return &processes[2 * static_cast<std::size_t>(rank)]; };
    for (const std::int64_t each : lost)
      if (process_of(each)[0] == process_of(post.rank())[0])
        mpi::end_sibling(static_cast<std::int64_t>(process_of(each)[1]));
  }

  /// Lets the last messages leave, but not wait for ranks that take none.
  void let_messages_leave() {
    for (int i = 0; i < 1000 && post.unsent() > 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  const mpi_options options;
  mpi::mpi_mailbox post{};
  std::vector<std::uint64_t> processes{}; ///< of each rank: its machine, and its number there
  std::uint64_t studies = 0;              ///< that have begun
  std::vector<std::int64_t> lost{};       ///< ranks, as of the last study
  bool is_first_lost = false, has_failed = false;
};

KANEXPR_MPI std::unique_ptr<mpi_ranks::state> mpi_ranks::begin(int& argc, char**& argv,
                                                               const mpi_options& options) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  return std::make_unique<state>(options);
}

KANEXPR_MPI mpi_ranks::mpi_ranks(int& argc, char**& argv, const mpi_options& options)
    : state_(begin(argc, argv, options)) {}

KANEXPR_MPI mpi_ranks::~mpi_ranks() {
  if (is_first())
    for (int i = 1; i < count(); ++i) state_->post.mailbox::send(i, mpi::farewell{});
  state_->let_messages_leave();
  // MPI_Finalize waits for who hangs. With `mpirun --enable-recovery` a rank may end without it, but mpirun
  // waits too; else MPI_Abort ends all ranks, the hanging ones among them.
  const char* recovery = std::getenv("OMPI_MCA_orte_enable_recovery");
  const bool recovers = recovery != nullptr && std::string_view(recovery) == "1";
  const bool has_lost = state_->is_first_lost || !state_->lost.empty();
  if (has_lost && recovers) {
    state_->end_lost_siblings();
    return;
  }
  if (has_lost && (is_first() || state_->is_first_lost)) {
    std::cout.flush();
    std::fflush(nullptr);
    MPI_Abort(MPI_COMM_WORLD, state_->has_failed ? EXIT_FAILURE : EXIT_SUCCESS);
  }
  MPI_Finalize();
}

KANEXPR_MPI int mpi_ranks::rank() const { return state_->post.rank(); }
KANEXPR_MPI int mpi_ranks::count() const { return state_->post.ranks(); }

KANEXPR_MPI ensemble_results mpi_ranks::run(const ensembles::job& study, const std::string& known_by,
                                            const ensemble_options& options) {
  const std::uint64_t number = ++state_->studies;
  bytes_writer known;
  known.put(mpi::this_program()), known.put(ensembles::identity_of(study.layout(), known_by));
  const std::uint64_t identity = ensembles::sum_of(known.bytes());
  ensemble_results found;
  if (is_first()) {
    mpi::first_rank first(state_->post, state_->options, number, identity);
    found = first.run(study, known_by, options);
    state_->lost = first.lost();
    for (int i = 1; i < count(); ++i)
      state_->post.mailbox::send(i,
                                 mpi::ending{number, found.done, found.failed, found.failure, state_->lost});
  } else {
    mpi::other_rank other(state_->post, state_->options, number, identity);
    mpi::ending told = other.run(study, options.threads > 0 ? options.threads : 1);
    state_->is_first_lost |= other.has_lost_the_first();
    state_->lost = std::move(told.lost);
    found.planned = study.layout().runs;
    found.done = told.done, found.failed = told.failed;
    found.failure = std::move(told.failure);
  }
  state_->has_failed |= !found;
  return found;
}

} // namespace kanexpr
