#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/base/version.hpp>
#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/checkpoint.ipp>
#include <kanexpr/ensembles/ensemble_options.hpp>
#include <kanexpr/ensembles/ensemble_results.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// Returns bytes that identify the content of a study and the version of the library.
inline std::string identity_of(const study_interface& study) {
  const study_layout& layout = study.layout();
  saver all;
  all(KANEXPR_VERSION, layout.study, study.identity(), layout.runs, layout.constants, layout.columns,
      layout.state, layout.samples, layout.events);
  return all.bytes();
}

/// Collects the results of runs, in the order of the runs, in tables, reductions and files; writes
/// checkpoints.
class collector {
  static constexpr std::size_t max_failures = 1000;
  using clock = std::chrono::steady_clock;

public:
  collector(const study_interface& study, const ensemble_options& options)
      : layout_(study.layout()), options_(options) {
    found_.planned = layout_.runs;
    found_.reductions = options.reduce;
    if (options.checkpoint) checkpoint_.emplace(options.checkpoint->text());
    saver all;
    all(identity_of(study), options.hold, options.files.size());
    for (const reduction& each : options.reduce) all(each.column, each.what.index(), each);
    identity_ = all.bytes();
  }

  /// Starts the study, or resumes it from its checkpoint; returns false on failure.
  bool begin() {
    return attempt([&] { return start(); });
  }
  std::size_t done() const { return found_.done; }
  /// Returns false after a failure, when no more runs are needed.
  bool add(std::vector<finished_run>&& runs) {
    return found_.failure.empty() && attempt([&] { return add_all(std::move(runs)); });
  }
  /// Completes the files and the checkpoint, and returns the results.
  ensemble_results end() {
    if (checkpoint_ && found_.failure.empty() && found_.done < found_.planned)
      attempt([&] { return write_checkpoint(); });
    for (std::size_t i = 0; i < open_files_; ++i) attempt([&] { return options_.files[i]->end(); });
    if (checkpoint_ && found_.failure.empty() && found_.done == found_.planned)
      attempt([&] { return checkpoint_->remove(); });
    const bool has_units = layout_.has_units();
    for (std::size_t i = 0; i < columns_.size(); ++i)
      attempt([&] {
        const auto& [name, unit] = layout_.columns[i];
        return found_.runs.add(name, std::move(columns_[i]), has_units ? unit : "");
      });
    for (const finished_run& each : held_) {
      if (!layout_.samples.empty()) found_.trajectories.push_back(trajectory_of(each));
      if (layout_.events.empty()) continue;
      found_.events.emplace_back();
      for (const auto& [which, when] : each.events)
        found_.events.back().push_back({when, layout_.events[which]});
    }
    return std::move(found_);
  }

private:
  /// Calls a step, which may call user functions, and keeps the first failure.
  template <class Step>
  bool attempt(const Step& step) {
    std::string cause;
    if (const auto thrown = exception_in([&] { cause = step().cause(); }))
      cause = "the results of the study could not be processed: " + *thrown;
    if (found_.failure.empty()) found_.failure = cause;
    return cause.empty();
  }

  outcome find_reduced_columns() {
    for (const reduction& each : found_.reductions) {
      const auto column = std::ranges::find(layout_.columns, each.column, &column_label::name);
      if (column == layout_.columns.end())
        return outcome("the study has no column " + each.column + " to reduce");
      if (const auto* bins = std::get_if<kanexpr::histogram>(&each.what); bins && !bins->is_valid())
        return outcome("the histogram of " + each.column + " requires between 1 and " +
                       std::to_string(kanexpr::histogram::max_bins) + " bins and a start below its end");
      reduced_.push_back(static_cast<std::size_t>(column - layout_.columns.begin()));
    }
    return {};
  }

  outcome start() {
    last_checkpoint_ = clock::now();
    if (outcome found = find_reduced_columns(); !found) return found;
    for (const auto& each : options_.files)
      if (outcome fits = each->fits(layout_); !fits) return fits;
    columns_.resize(options_.hold ? layout_.columns.size() : 0);
    std::vector<std::string> positions;
    if (checkpoint_)
      if (outcome read = open_checkpoint(positions); !read) return read;
    for (std::size_t i = 0; i < options_.files.size(); ++i) {
      results_file& file = *options_.files[i];
      if (outcome opened = positions.empty() ? file.begin(layout_) : file.resume(layout_, positions[i]);
          !opened)
        return opened;
      ++open_files_;
    }
    return {};
  }

  outcome open_checkpoint(std::vector<std::string>& positions) {
    std::string content;
    if (outcome read = checkpoint_->read(content); !read) return read;
    if (!content.empty()) return resume_from(content, positions);
    // If the checkpoint cannot be written, this is reported before the first run, not an hour later.
    outcome written = checkpoint_->write({});
    return written ? checkpoint_->remove() : written;
  }

  outcome add_all(std::vector<finished_run>&& runs) {
    for (finished_run& each : runs) {
      for (const auto& file : options_.files)
        if (outcome taken = file->take(each); !taken) return taken;
      add_one(std::move(each));
    }
    if (options_.progress)
      options_.progress(static_cast<double>(found_.done), 0, static_cast<double>(found_.planned));
    const std::chrono::duration<double> since = clock::now() - last_checkpoint_;
    return checkpoint_ && since.count() >= options_.checkpoint_every ? write_checkpoint() : outcome();
  }

  void add_one(finished_run&& one) {
    ++found_.done;
    if (one.has_failed()) {
      ++found_.failed;
      if (found_.failures.size() < max_failures)
        found_.failures.push_back({one.run, one.time, one.state, one.failure});
    } else {
      for (std::size_t i = 0; i < reduced_.size(); ++i) found_.reductions[i].take(one.values[reduced_[i]]);
    }
    for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i].push_back(one.values[i]);
    if (options_.hold && !(layout_.samples.empty() && layout_.events.empty())) {
      one.values = {}, one.state = {}, one.failure = {};
      held_.push_back(std::move(one));
    }
  }

  outcome write_checkpoint() {
    saver all;
    all(identity_);
    for (const auto& file : options_.files) {
      std::string position;
      if (outcome flushed = file->flush(position); !flushed) return flushed;
      all(position);
    }
    exchange(all);
    outcome done = checkpoint_->write(all.bytes());
    last_checkpoint_ = clock::now();
    return done;
  }

  outcome resume_from(const std::string& content, std::vector<std::string>& positions) {
    loader all(content);
    std::string identity;
    all(identity);
    if (all && identity != identity_) return checkpoint_->of_another_study();
    positions.resize(options_.files.size());
    for (std::string& each : positions) all(each);
    exchange(all);
    return all.is_at_end() && found_.done <= layout_.runs ? outcome() : checkpoint_->damaged();
  }

  void exchange(auto& archive) {
    archive(found_.done, found_.failed, found_.failures, held_);
    for (reduction& each : found_.reductions) archive(each);
    for (std::vector<double>& each : columns_) archive(each);
  }

  table trajectory_of(const finished_run& one) const {
    table path;
    const bool has_units = layout_.has_units();
    const std::size_t width = layout_.samples.size();
    for (std::size_t i = 0; i < width; ++i) {
      std::vector<double> column;
      for (std::size_t k = i; k < one.samples.size(); k += width) column.push_back(one.samples[k]);
      const auto& [name, unit] = layout_.samples[i];
      static_cast<void>(path.add(name, std::move(column), has_units ? unit : "")); // the names are distinct
    }
    return path;
  }

  const study_layout& layout_;
  const ensemble_options& options_;
  std::string identity_{};
  std::optional<checkpoint_file> checkpoint_{};
  ensemble_results found_{};
  std::vector<std::vector<double>> columns_{};
  std::vector<std::size_t> reduced_{}; ///< the column of each reduction
  std::vector<finished_run> held_{};   ///< trajectories and events
  std::size_t open_files_ = 0;
  clock::time_point last_checkpoint_{};
};

} // namespace kanexpr::ensembles
