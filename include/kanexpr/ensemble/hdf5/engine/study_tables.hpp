#pragma once

#include <kanexpr/ensemble/finished_run.hpp>
#include <kanexpr/ensemble/hdf5/engine/rows.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::ensembles {

/// The datasets that hold what a study keeps.
class study_tables {
public:
  static constexpr std::size_t bytes_of_cause = 512;

  struct named_rows {
    const char* name;
    row_columns columns;
    growing_rows* rows;
  };

  explicit study_tables(const study_layout& layout) : layout_(layout) {
    all_.push_back({"runs", columns_of_runs(), &runs_});
    all_.push_back({"failures", columns_of_failures(), &failures_});
    if (!layout_.samples.empty()) all_.push_back({"samples", columns_of_samples(), &samples_});
    if (!layout_.events.empty()) all_.push_back({"events", columns_of_events(), &events_});
  }
  study_tables(const study_tables&) = delete;
  study_tables& operator=(const study_tables&) = delete;
  ~study_tables() = default;

  /// Those that the study has.
  const std::vector<named_rows>& all() const { return all_; }

  bool create(hid_t file, int compression) {
    for (const named_rows& each : all_)
      if (!each.rows->create(file, each.name, each.columns, compression)) return false;
    return write_attribute(file, "study", layout_.study) &&
           write_attribute(file, "planned_runs", layout_.runs) && write_constants(file) &&
           write_attribute(runs_.id(), "varied", layout_.varied) &&
           write_attribute(runs_.id(), "ends",
                           std::vector<std::string>{"reached_end", "stopped_by_event", "failed"}) &&
           (layout_.events.empty() || write_attribute(events_.id(), "names", layout_.events));
  }
  bool open(hid_t file) {
    for (const named_rows& each : all_)
      if (!each.rows->open(file, each.name, each.columns)) return false;
    return true;
  }

  /// Rows wait until they are written.
  void take(const finished_run& run) {
    const std::uint64_t number = run.run;
    runs_.put(number), runs_.put(static_cast<std::uint8_t>(run.end));
    runs_.put(std::span(run.values).subspan(2));
    if (run.end == run_end::failed) {
      failures_.put(number), failures_.put(run.time);
      for (std::size_t i = 0; i < layout_.state.size(); ++i) // none is told where a function has thrown
        failures_.put(i < run.state.size() ? run.state[i] : std::numeric_limits<double>::quiet_NaN());
      failures_.put(cut(run.failure), bytes_of_cause);
    }
    const std::size_t width = layout_.samples.size();
    for (std::size_t i = 0; i < run.samples.size(); i += width) {
      samples_.put(number);
      samples_.put(std::span(run.samples).subspan(i, width));
    }
    for (const auto& [which, when] : run.events) events_.put(number), events_.put(when), events_.put(which);
  }

  bool has_many_waiting() const {
    return std::ranges::any_of(all_, [](const named_rows& each) { return each.rows->has_many_waiting(); });
  }
  bool write() {
    return std::ranges::all_of(all_, [](const named_rows& each) { return each.rows->write(); });
  }

private:
  /// As one row, whose fields have their names.
  bool write_constants(hid_t file) const {
    if (layout_.constants.empty()) return true;
    row_columns names;
    std::vector<double> values;
    for (const constant_of_runs& each : layout_.constants) {
      names.add(each.what, H5T_NATIVE_DOUBLE);
      values.push_back(each.value);
    }
    const hdf5_handle type = names.type(), one(H5Screate(H5S_SCALAR), &H5Sclose);
    return type && write_attribute(file, "constants", type.id(), one.id(), values.data()) &&
           write_attribute(file, "units_of_constants", names.units());
  }
  row_columns columns_of_runs() const {
    row_columns all;
    all.add(layout_.columns[0], H5T_NATIVE_UINT64);
    all.add(layout_.columns[1], H5T_NATIVE_UINT8);
    for (std::size_t i = 2; i < layout_.columns.size(); ++i) all.add(layout_.columns[i], H5T_NATIVE_DOUBLE);
    return all;
  }
  row_columns columns_of_failures() const {
    row_columns all;
    all.add({unlike(layout_.state, "run")}, H5T_NATIVE_UINT64);
    all.add({unlike(layout_.state, "t_end"), "s"}, H5T_NATIVE_DOUBLE);
    for (const column_label& each : layout_.state) all.add(each, H5T_NATIVE_DOUBLE);
    all.add_text(unlike(layout_.state, "cause"), bytes_of_cause);
    return all;
  }
  row_columns columns_of_samples() const {
    row_columns all;
    all.add({unlike(layout_.samples, "run")}, H5T_NATIVE_UINT64);
    for (const column_label& each : layout_.samples) all.add(each, H5T_NATIVE_DOUBLE);
    return all;
  }
  row_columns columns_of_events() const {
    row_columns all;
    all.add({"run"}, H5T_NATIVE_UINT64);
    all.add({"t", "s"}, H5T_NATIVE_DOUBLE);
    all.add({"event"}, H5T_NATIVE_UINT32);
    return all;
  }

  static std::string unlike(const std::vector<column_label>& others, std::string name) {
    while (std::ranges::find(others, name, &column_label::name) != others.end()) name += '_';
    return name;
  }
  /// What of a sentence there is room for, in whole letters of UTF-8.
  static std::string cut(std::string text) {
    constexpr std::string_view dots = "\xE2\x80\xA6";
    if (text.size() <= bytes_of_cause) return text;
    std::size_t end = bytes_of_cause - dots.size();
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return text.substr(0, end).append(dots);
  }

  study_layout layout_;
  growing_rows runs_{}, failures_{}, samples_{}, events_{};
  std::vector<named_rows> all_{};
};

} // namespace kanexpr::ensembles
