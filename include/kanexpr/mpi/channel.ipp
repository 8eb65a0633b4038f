#pragma once

#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/run_scheduler.ipp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <mpi.h>

namespace kanexpr::mpi {

/// The tags of messages to the first rank, from the first rank to another rank, and from the first rank to
/// each thread of another rank.
enum tag : int { to_first = 0, to_rank = 1, to_thread = 2 };

/// The messages to the first rank: a thread requests a share, a rank has no more threads at work and waits
/// for the summary of the study, or a rank no longer takes part in studies.
enum class request : std::uint8_t { share, summary, leave };

/// The message to the first rank. A thread that requests a share also reports the results of its previous
/// share.
struct report {
  request wants = request::share;
  std::uint64_t study = 0; ///< the hash of its identity
  int thread = 0;
  ensembles::finished_share done{};

  static void fields(auto& self, auto& archive) { archive(self.wants, self.study, self.thread, self.done); }
};

/// The result of a study, for ranks other than the first.
struct summary {
  std::size_t done = 0, failed = 0;
  std::string failure{};

  static void fields(auto& self, auto& archive) { archive(self.done, self.failed, self.failure); }
};

/// The content of a message, and its sender.
template <class Content>
struct message {
  int from = 0;
  Content content{};
};

/// Messages between ranks. A function that waits polls MPI and sleeps in between, so that a waiting rank
/// leaves its core to others, and any thread may wait. MPI errors are thrown as std::runtime_error.
class channel {
  static constexpr std::size_t word = 8; // messages are counted in words, because MPI counts with an int

public:
  channel() {
    throw_if_failed(MPI_Comm_dup(MPI_COMM_WORLD, &all_));
    MPI_Comm_set_errhandler(all_, MPI_ERRORS_RETURN);
    MPI_Comm_rank(all_, &rank_);
    MPI_Comm_size(all_, &ranks_);
  }
  channel(const channel&) = delete;
  channel& operator=(const channel&) = delete;
  ~channel() { MPI_Comm_free(&all_); }

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }

  template <class Content>
  void send(int to, int tag, const Content& content) {
    ensembles::saver all;
    all(content);
    std::string bytes = all.bytes();
    bytes.resize((bytes.size() / word + 1) * word);
    const std::scoped_lock lock(mutex_);
    throw_if_failed(
        MPI_Send(bytes.data(), static_cast<int>(bytes.size() / word), MPI_UINT64_T, to, tag, all_));
  }

  template <class Content>
  message<Content> receive(int from, int tag) {
    for (int tries = 0;; ++tries) {
      if (auto found = try_receive<Content>(from, tag)) return *std::move(found);
      pause(tries);
    }
  }

  /// Returns a message that has arrived, if there is one.
  template <class Content>
  std::optional<message<Content>> try_receive(int from, int tag) {
    int is_there = 0, words = 0;
    MPI_Message handle;
    MPI_Status envelope;
    const std::scoped_lock lock(mutex_);
    throw_if_failed(MPI_Improbe(from, tag, all_, &is_there, &handle, &envelope));
    if (is_there == 0) return std::nullopt;
    throw_if_failed(MPI_Get_count(&envelope, MPI_UINT64_T, &words));
    std::string bytes(static_cast<std::size_t>(words) * word, '\0');
    throw_if_failed(MPI_Mrecv(bytes.data(), words, MPI_UINT64_T, &handle, MPI_STATUS_IGNORE));
    message<Content> found{envelope.MPI_SOURCE, {}};
    ensembles::loader all(bytes);
    all(found.content);
    return found;
  }

  /// Yields the processor at first, and sleeps after many tries.
  static void pause(int tries) {
    if (tries < 100)
      std::this_thread::yield();
    else
      std::this_thread::sleep_for(std::chrono::microseconds(500));
  }

private:
  static void throw_if_failed(int code) {
    if (code == MPI_SUCCESS) return;
    char text[MPI_MAX_ERROR_STRING] = {};
    int length = 0;
    MPI_Error_string(code, text, &length);
    throw std::runtime_error("MPI reported an error: " + std::string(text, static_cast<std::size_t>(length)));
  }

  std::mutex mutex_{}; ///< MPI is called by one thread at a time
  MPI_Comm all_ = MPI_COMM_NULL;
  int rank_ = 0, ranks_ = 1;
};

} // namespace kanexpr::mpi
