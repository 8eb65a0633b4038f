#pragma once

#include <kanexpr/ensembles/finished_run.hpp>
#include <kanexpr/ensembles/hdf5/rows.ipp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// The datasets of a study.
class study_tables {
  static constexpr std::size_t cause_bytes = 512;
  struct dataset {
    const char* name;
    row_columns columns;
    growing_rows* rows;
  };

public:
  explicit study_tables(const study_layout& layout) : layout_(layout) {
    row_columns runs;
    runs.add(layout_.columns[0], H5T_NATIVE_UINT64), runs.add(layout_.columns[1], H5T_NATIVE_UINT8);
    runs.add({layout_.columns.begin() + 2, layout_.columns.end()});
    all_.push_back({"runs", std::move(runs), &runs_});
    row_columns failures;
    failures.add({unlike(layout_.state, "run")}, H5T_NATIVE_UINT64);
    failures.add({unlike(layout_.state, "t_end"), "s"}, H5T_NATIVE_DOUBLE);
    failures.add(layout_.state);
    failures.add({unlike(layout_.state, "cause")}, text_type(cause_bytes).id());
    all_.push_back({"failures", std::move(failures), &failures_});
    row_columns samples, events;
    samples.add({unlike(layout_.samples, "run")}, H5T_NATIVE_UINT64);
    samples.add(layout_.samples);
    if (!layout_.samples.empty()) all_.push_back({"samples", std::move(samples), &samples_});
    events.add({"run"}, H5T_NATIVE_UINT64), events.add({"t", "s"}, H5T_NATIVE_DOUBLE);
    events.add({"event"}, H5T_NATIVE_UINT32);
    if (!layout_.events.empty()) all_.push_back({"events", std::move(events), &events_});
  }
  study_tables(const study_tables&) = delete;
  study_tables& operator=(const study_tables&) = delete;
  ~study_tables() = default;

  /// Calls a function of each dataset's rows until one returns false.
  template <class Function>
  bool for_all(const Function& call) const {
    return std::ranges::all_of(all_, [&](const dataset& each) { return call(*each.rows); });
  }

  bool create(hid_t file, int compression) {
    for (const dataset& each : all_)
      if (!each.rows->create(file, each.name, each.columns, compression)) return false;
    const std::vector<std::string> ends{"reached_end", "stopped_by_event", "failed"};
    return write_attribute(file, "study", layout_.study) &&
           write_attribute(file, "planned_runs", layout_.runs) && write_constants(file) &&
           write_attribute(runs_.id(), "varied", layout_.varied) &&
           write_attribute(runs_.id(), "ends", ends) &&
           (layout_.events.empty() || write_attribute(events_.id(), "names", layout_.events));
  }
  bool open(hid_t file) {
    return std::ranges::all_of(
        all_, [&](const dataset& each) { return each.rows->open(file, each.name, each.columns); });
  }

  void put(const finished_run& run) {
    const std::uint64_t number = run.run;
    runs_.put(number), runs_.put(static_cast<std::uint8_t>(run.end));
    runs_.put(std::span(run.values).subspan(2));
    if (run.end == run_end::failed) {
      failures_.put(number), failures_.put(run.time);
      for (std::size_t i = 0; i < layout_.state.size(); ++i) // unknown if a function threw
        failures_.put(i < run.state.size() ? run.state[i] : std::numeric_limits<double>::quiet_NaN());
      failures_.put(shortened(run.failure), cause_bytes);
    }
    const std::size_t width = layout_.samples.size();
    for (std::size_t i = 0; i < run.samples.size(); i += width)
      samples_.put(number), samples_.put(std::span(run.samples).subspan(i, width));
    for (const auto& [which, when] : run.events) events_.put(number), events_.put(when), events_.put(which);
  }

private:
  bool write_constants(hid_t file) const {
    if (layout_.constants.empty()) return true;
    row_columns names;
    std::vector<double> values;
    for (const constant_of_runs& each : layout_.constants) {
      names.add(each.what, H5T_NATIVE_DOUBLE);
      values.push_back(each.value);
    }
    const hdf5_handle type = names.type();
    return type && write_attribute(file, "constants", type.id(), values.data()) &&
           write_attribute(file, "units_of_constants", names.units());
  }

  static std::string unlike(const std::vector<column_label>& others, std::string name) {
    while (std::ranges::find(others, name, &column_label::name) != others.end()) name += '_';
    return name;
  }
  /// The part of a sentence that fits, cut between characters of UTF-8.
  static std::string shortened(const std::string& text) {
    constexpr std::string_view dots = "\xE2\x80\xA6";
    if (text.size() <= cause_bytes) return text;
    std::size_t end = cause_bytes - dots.size();
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return text.substr(0, end).append(dots);
  }

  study_layout layout_;
  growing_rows runs_{}, failures_{}, samples_{}, events_{};
  std::vector<dataset> all_{};
};

} // namespace kanexpr::ensembles
