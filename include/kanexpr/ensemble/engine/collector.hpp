#pragma once

#include <kanexpr/base/version.hpp>
#include <kanexpr/ensemble/checkpoint.hpp>
#include <kanexpr/ensemble/collector.hpp>
#include <kanexpr/ensemble/engine/taken_names.hpp>

#include <algorithm>
#include <exception>
#include <utility>

namespace kanexpr {

namespace ensembles {

inline constexpr std::size_t most_failures_held = 1000;

KANEXPR_ENSEMBLES std::string identity_of(const study_layout& layout, const std::string& known_by) {
  bytes_writer all;
  all.put(KANEXPR_VERSION);
  all.put(layout.study), all.put(known_by), all.put(layout.runs);
  for (const auto* columns : {&layout.columns, &layout.state, &layout.samples}) {
    all.put(columns->size());
    for (const column_label& each : *columns) all.put(each.name), all.put(each.unit);
  }
  for (const constant_of_runs& each : layout.constants) all.put(each.what.unit);
  for (const std::string& each : layout.events) all.put(each);
  return all.bytes();
}

/// The same with what becomes of its results, as its checkpoint knows it again.
inline std::string identity_of(const study_layout& layout, const std::string& known_by,
                               const ensemble_options& options) {
  bytes_writer all;
  all.put(identity_of(layout, known_by));
  all.put(options.hold), all.put(options.files.size());
  for (const reduction& each : options.reduce) {
    all.put(each.column), all.put(each.what.index());
    if (const auto* bins = std::get_if<kanexpr::histogram>(&each.what)) bins->write(all);
  }
  return all.bytes();
}

/// What comes of a step that calls functions of the user, also where they throw.
template <class Step>
outcome without_throwing(const Step& step) {
  const std::string cause = "the results of the study could not be taken: ";
  try {
    return step();
  } catch (const std::exception& thrown) {
    return outcome(cause + thrown.what());
  } catch (...) {
    return outcome(cause + "what was thrown is no std::exception");
  }
}

KANEXPR_ENSEMBLES collector::collector(const study_layout& layout, const std::string& known_by,
                                       const ensemble_options& options)
    : layout_(layout), known_by_(options.checkpoint ? identity_of(layout, known_by, options) : std::string()),
      options_(options) {
  found_.planned = layout.runs;
  found_.reductions = options.reduce;
}

KANEXPR_ENSEMBLES bool collector::begin() {
  const outcome begun = without_throwing([&] { return begin_files(); });
  return begun || fail(begun);
}

KANEXPR_ENSEMBLES outcome collector::begin_files() {
  noted_ = std::chrono::steady_clock::now();
  for (const reduction& each : found_.reductions) {
    const auto column = std::ranges::find(layout_.columns, each.column, &column_label::name);
    if (column == layout_.columns.end())
      return outcome("the study has no column " + each.column + " to reduce");
    if (const auto* bins = std::get_if<kanexpr::histogram>(&each.what);
        bins && !(bins->bins() > 0 && bins->edge(0) < bins->edge(bins->bins())))
      return outcome("the histogram of " + each.column + " needs a bin at least and " +
                     std::to_string(kanexpr::histogram::most_bins) +
                     " at most, and must begin below its end");
    reduced_.push_back(static_cast<std::size_t>(column - layout_.columns.begin()));
  }
  taken_names names;
  if (options_.checkpoint)
    static_cast<void>(names.take(options_.checkpoint->text(), "the checkpoint of the study")); // the first
  for (const auto& each : options_.files) {
    if (outcome fits = each->fits(layout_); !fits) return fits;
    if (outcome is_free = names.take(each->path(), "a file of results"); !is_free) return is_free;
  }
  columns_.resize(options_.hold ? layout_.columns.size() : 0);
  if (options_.checkpoint) {
    if (outcome held = checkpoint_.hold(options_.checkpoint->text()); !held) return held;
    noted before = checkpoint_.read();
    if (!before) return before;
    if (before.content && !before.content->empty()) return go_on_from(*before.content);
    // Before anything else is written: a checkpoint that cannot be is no surprise after an hour. An empty one
    // stays where the program ends right then.
    if (outcome can = checkpoint_.write({}); !can) return can;
    if (outcome gone = checkpoint_.remove(); !gone) return gone;
  }
  for (const auto& each : options_.files) {
    if (outcome begun = each->begin(layout_); !begun) return begun;
    ++begun_;
  }
  return {};
}

KANEXPR_ENSEMBLES bool collector::take(std::vector<finished_run>&& runs) {
  if (!found_.failure.empty()) return false;
  const outcome taken = without_throwing([&] { return take_all(std::move(runs)); });
  return taken || fail(taken);
}

KANEXPR_ENSEMBLES outcome collector::take_all(std::vector<finished_run>&& runs) {
  for (finished_run& each : runs) {
    for (const auto& file : options_.files)
      if (outcome taken = file->take(each); !taken) return taken;
    take_one(std::move(each));
  }
  if (options_.progress)
    options_.progress(static_cast<double>(found_.done), 0, static_cast<double>(found_.planned));
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - noted_;
  return options_.checkpoint && since.count() >= options_.checkpoint_every ? note_now() : outcome();
}

KANEXPR_ENSEMBLES void collector::take_one(finished_run&& one) {
  ++found_.done;
  if (one.end == run_end::failed) {
    ++found_.failed;
    if (found_.failures.size() < most_failures_held)
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

KANEXPR_ENSEMBLES outcome collector::note_now() {
  bytes_writer all;
  all.put(known_by_);
  for (const auto& file : options_.files) {
    std::string position;
    if (outcome flushed = file->flush(position); !flushed) return flushed;
    all.put(position);
  }
  all.put(found_.done), all.put(found_.failed);
  all.put(found_.failures.size());
  for (const failed_run& each : found_.failures) {
    all.put(each.run), all.put(each.time);
    all.put(each.state), all.put(each.cause);
  }
  for (const reduction& each : found_.reductions) each.write(all);
  for (const std::vector<double>& each : columns_) all.put(each);
  all.put(held_.size());
  for (const finished_run& each : held_) each.write(all);
  outcome done = checkpoint_.write(all.bytes());
  noted_ = std::chrono::steady_clock::now();
  return done;
}

KANEXPR_ENSEMBLES outcome collector::go_on_from(const std::string& noted) {
  const std::string& path = options_.checkpoint->text();
  bytes_reader all(noted);
  if (all.get_text() != known_by_)
    return outcome(
        path + " is of another study, another model or another version of kanexpr; remove it to begin anew");
  std::vector<std::string> positions;
  while (positions.size() < options_.files.size()) positions.push_back(all.get_text());
  found_.done = all.get<std::size_t>();
  found_.failed = all.get<std::size_t>();
  for (auto left = all.get<std::size_t>(); left > 0 && all; --left) {
    failed_run one{};
    one.run = all.get<std::size_t>(), one.time = all.get<double>();
    one.state = all.get_all<double>(), one.cause = all.get_text();
    found_.failures.push_back(std::move(one));
  }
  for (reduction& each : found_.reductions) each.read(all);
  for (std::vector<double>& each : columns_) each = all.get_all<double>();
  for (auto left = all.get<std::size_t>(); left > 0 && all; --left) held_.push_back(finished_run::read(all));
  if (!all.is_at_end() || found_.done > layout_.runs) return outcome(path + " is damaged");
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (outcome opened = options_.files[i]->go_on(layout_, positions[i]); !opened) return opened;
    ++begun_;
  }
  return {};
}

KANEXPR_ENSEMBLES ensemble_results collector::end() {
  if (options_.checkpoint && found_.failure.empty() && found_.done < found_.planned)
    if (outcome noted = without_throwing([&] { return note_now(); }); !noted) fail(noted);
  for (std::size_t i = 0; i < begun_; ++i)
    if (outcome ended = without_throwing([&] { return options_.files[i]->end(); });
        !ended && found_.failure.empty())
      fail(ended);
  if (options_.checkpoint && found_.failure.empty() && found_.done == found_.planned)
    if (outcome gone = checkpoint_.remove(); !gone) fail(gone);
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (outcome added = found_.runs.add(layout_.columns[i].name, std::move(columns_[i])); !added) fail(added);
  for (const finished_run& each : held_) {
    if (!layout_.samples.empty()) found_.trajectories.push_back(trajectory_of(each));
    if (layout_.events.empty()) continue;
    found_.events.emplace_back();
    for (const auto& [which, when] : each.events)
      found_.events.back().push_back({when, layout_.events[which]});
  }
  return std::move(found_);
}

KANEXPR_ENSEMBLES table collector::trajectory_of(const finished_run& one) const {
  table path;
  const std::size_t width = layout_.samples.size();
  for (std::size_t i = 0; i < width; ++i) {
    std::vector<double> column;
    for (std::size_t at = i; at < one.samples.size(); at += width) column.push_back(one.samples[at]);
    static_cast<void>(path.add(layout_.samples[i].name, std::move(column))); // names differ
  }
  return path;
}

KANEXPR_ENSEMBLES bool collector::fail(const outcome& done) {
  found_.failure = done.cause();
  return false;
}

} // namespace ensembles

} // namespace kanexpr
