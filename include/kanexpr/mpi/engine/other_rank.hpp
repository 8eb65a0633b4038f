#pragma once

#include <kanexpr/mpi/engine/patience.hpp>
#include <kanexpr/mpi/mailbox.hpp>
#include <kanexpr/mpi/worker_threads.hpp>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace kanexpr::mpi {

/// A rank that does what it is told in one study.
class other_rank {
public:
  other_rank(mailbox& post, const mpi_options& options, std::uint64_t study, std::uint64_t known_by)
      : post_(post), options_(options), study_(study), known_by_(known_by) {}

  ending run(const ensembles::job& study, std::size_t threads) {
    worker_threads own(study, threads);
    tell(own);
    nap rest;
    while (!is_over_) {
      bool was_idle = true;
      while (!is_over_) {
        const auto come = post_.receive();
        if (!come) break;
        take(*come, own), was_idle = false;
      }
      if (auto done = own.finished(); !done.empty() || seconds_since(told_) > seconds_of_sign(options_))
        tell(own, std::move(done));
      has_lost_the_first_ = seconds_since(heard_) > options_.patience;
      if (has_lost_the_first_)
        end("the first rank has not been heard of for " + std::to_string(std::llround(options_.patience)) +
            " seconds");
      if (was_idle)
        own.wait(rest.next());
      else
        rest.reset();
    }
    return found_;
  }

  bool has_lost_the_first() const { return has_lost_the_first_; }

private:
  void tell(const worker_threads& own, std::vector<ensembles::finished_share> done = {}) {
    post_.send(0, report{study_, known_by_, own.room(), std::move(done)});
    told_ = clock::now();
  }

  void take(const letter& come, worker_threads& own) {
    heard_ = clock::now();
    if (come.kind == kind_of_message::orders) {
      const auto told = come.read<orders>();
      if (told.study == study_)
        for (const ensembles::share& each : told.shares) own.give(each);
    } else if (come.kind == kind_of_message::ending) {
      if (auto told = come.read<ending>(); told.study == study_) found_ = std::move(told), is_over_ = true;
    } else if (come.kind == kind_of_message::farewell) {
      end("the first rank has ended without this study");
    }
  }

  void end(std::string why) {
    found_.failure = std::move(why);
    is_over_ = true;
  }

  mailbox& post_;
  const mpi_options& options_;
  const std::uint64_t study_, known_by_;
  ending found_{};
  bool is_over_ = false, has_lost_the_first_ = false;
  clock::time_point heard_ = clock::now(), told_{};
};

} // namespace kanexpr::mpi
