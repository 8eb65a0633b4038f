#pragma once

#include <kanexpr/mpi/mailbox.hpp>

#include <algorithm>
#include <cstddef>
#include <list>
#include <utility>
#include <vector>

#include <mpi.h>

namespace kanexpr::mpi {

/// By MPI, on a communicator of its own.
class mpi_mailbox final : public mailbox {
public:
  mpi_mailbox() {
    // What goes wrong with a rank that is gone must not end the others.
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    MPI_Comm_dup(MPI_COMM_WORLD, &all_);
    MPI_Comm_rank(all_, &rank_);
    MPI_Comm_size(all_, &ranks_);
  }

  mpi_mailbox(const mpi_mailbox&) = delete;
  mpi_mailbox& operator=(const mpi_mailbox&) = delete;

  int rank() const override { return rank_; }
  int ranks() const override { return ranks_; }

  using mailbox::send;
  void send(int to, kind_of_message kind, std::string content) override {
    free_sent();
    // Counted in words, of which an int can count enough.
    content.resize((content.size() / word + 1) * word);
    sent_.push_back({{to, kind, std::move(content)}, MPI_REQUEST_NULL});
    auto& [one, request] = sent_.back();
    if (MPI_Isend(one.content.data(), words_of(one.content), MPI_UINT64_T, to, static_cast<int>(kind), all_,
                  &request) != MPI_SUCCESS)
      sent_.pop_back();
  }

  std::optional<letter> receive() override {
    begin_to_receive();
    const auto come =
        std::find_if(coming_.begin(), coming_.end(), [](on_its_way& each) { return is_there(each); });
    if (come == coming_.end()) return std::nullopt;
    std::optional<letter> found = std::move(come->what);
    coming_.erase(come);
    return found;
  }

  /// How many messages have not left this rank.
  std::size_t unsent() {
    free_sent();
    return sent_.size();
  }

private:
  struct on_its_way {
    letter what;
    MPI_Request request;
  };
  static constexpr std::size_t word = 8;
  static int words_of(const std::string& content) { return static_cast<int>(content.size() / word); }

  static bool is_there(on_its_way& one) {
    int there = 0;
    return MPI_Test(&one.request, &there, MPI_STATUS_IGNORE) == MPI_SUCCESS && there != 0;
  }

  void free_sent() { sent_.remove_if(is_there); }

  /// Large messages come in parts, of which the last ones may never come: nothing is waited for.
  void begin_to_receive() {
    int found = 0;
    MPI_Message message;
    MPI_Status status;
    if (MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, all_, &found, &message, &status) != MPI_SUCCESS ||
        found == 0)
      return;
    int count = 0;
    MPI_Get_count(&status, MPI_UINT64_T, &count);
    coming_.push_back({{status.MPI_SOURCE, static_cast<kind_of_message>(status.MPI_TAG),
                        std::string(static_cast<std::size_t>(count) * word, '\0')},
                       MPI_REQUEST_NULL});
    auto& [one, request] = coming_.back();
    if (MPI_Imrecv(one.content.data(), count, MPI_UINT64_T, &message, &request) != MPI_SUCCESS)
      coming_.pop_back();
  }

  MPI_Comm all_ = MPI_COMM_NULL;
  int rank_ = 0, ranks_ = 1;
  std::list<on_its_way> sent_{}, coming_{};
};

} // namespace kanexpr::mpi
