#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensemble/sharing.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::mpi {

/// What ranks say to each other. Those of a program do the same studies in the same order, so the number of a
/// study tells what is of another one.
enum class kind_of_message : std::uint8_t { report, orders, ending, farewell };

/// From another rank to the first: that it lives, and what it has done.
struct report {
  static constexpr kind_of_message kind = kind_of_message::report;
  std::uint64_t study = 0;
  std::uint64_t known_by = 0; ///< what the study is
  std::size_t room = 0;       ///< so many shares it takes at a time
  std::vector<ensembles::finished_share> done{};

  void write(bytes_writer& out) const {
    out.put(study), out.put(known_by), out.put(room), out.put(done.size());
    for (const ensembles::finished_share& each : done) {
      out.put(each.what.first), out.put(each.seconds);
      out.put(each.runs.size());
      for (const finished_run& one : each.runs) one.write(out);
    }
  }
  static report read(bytes_reader& in) {
    report all;
    all.study = in.get<std::uint64_t>(), all.known_by = in.get<std::uint64_t>();
    all.room = in.get<std::size_t>();
    for (auto left = in.get<std::size_t>(); left > 0 && in; --left) {
      ensembles::finished_share one;
      one.what.first = in.get<std::size_t>(), one.seconds = in.get<double>();
      for (auto runs = in.get<std::size_t>(); runs > 0 && in; --runs)
        one.runs.push_back(finished_run::read(in));
      one.what.count = one.runs.size();
      all.done.push_back(std::move(one));
    }
    return all;
  }
};

/// From the first rank to another: that it lives, and what there is to do.
struct orders {
  static constexpr kind_of_message kind = kind_of_message::orders;
  std::uint64_t study = 0;
  std::vector<ensembles::share> shares{};

  void write(bytes_writer& out) const {
    out.put(study), out.put(shares.size());
    for (const ensembles::share& each : shares) out.put(each.first), out.put(each.count);
  }
  static orders read(bytes_reader& in) {
    orders all;
    all.study = in.get<std::uint64_t>();
    for (auto left = in.get<std::size_t>(); left > 0 && in; --left) {
      ensembles::share one;
      one.first = in.get<std::size_t>();
      one.count = in.get<std::size_t>();
      all.shares.push_back(one);
    }
    return all;
  }
};

/// From the first rank to the others: what came of the study.
struct ending {
  static constexpr kind_of_message kind = kind_of_message::ending;
  std::uint64_t study = 0;
  std::size_t done = 0, failed = 0;
  std::string failure{};
  std::vector<std::int64_t> lost{}; ///< ranks of which nothing was heard any more

  void write(bytes_writer& out) const {
    out.put(study), out.put(done), out.put(failed), out.put(failure), out.put(lost);
  }
  static ending read(bytes_reader& in) {
    ending all;
    all.study = in.get<std::uint64_t>();
    all.done = in.get<std::size_t>(), all.failed = in.get<std::size_t>();
    all.failure = in.get_text(), all.lost = in.get_all<std::int64_t>();
    return all;
  }
};

/// From the first rank to the others: that it does no more studies.
struct farewell {
  static constexpr kind_of_message kind = kind_of_message::farewell;
  void write(bytes_writer&) const {}
};

} // namespace kanexpr::mpi
