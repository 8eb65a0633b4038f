#pragma once

#include <kanexpr/ensembles/hdf5/handles.ipp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// A dataset to which rows are appended. Its functions return false on HDF5 errors.
class growing_table {
  static constexpr std::size_t chunk_bytes = 131072; // HDF5's chunk cache holds several of these

public:
  growing_table(std::string name, row_type columns)
      : name_(std::move(name)), type_(std::move(columns)),
        chunk_rows_((std::max)(chunk_bytes / (type_.size() + !type_), std::size_t{1})) {}

  bool create(hid_t file, int compression) {
    const hsize_t none = 0, most = H5S_UNLIMITED, chunk = chunk_rows_;
    const hdf5_handle space(H5Screate_simple(1, &none, &most), &H5Sclose);
    const hdf5_handle how(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose);
    if (!type_ || H5Pset_chunk(how.id(), 1, &chunk) < 0 || H5Pset_obj_track_times(how.id(), false) < 0 ||
        (compression > 0 && H5Pset_deflate(how.id(), static_cast<unsigned>(compression)) < 0))
      return false;
    rows_ = {H5Dcreate2(file, name_.c_str(), type_.id(), space.id(), H5P_DEFAULT, how.id(), H5P_DEFAULT),
             &H5Dclose};
    return rows_ && write_attribute(rows_.id(), "units", type_.units());
  }

  /// Opens a table of an interrupted study, in which new rows follow the first `done` rows.
  bool open(hid_t file, hsize_t done) {
    rows_ = {H5Dopen2(file, name_.c_str(), H5P_DEFAULT), &H5Dclose};
    const hdf5_handle type(H5Dget_type(rows_.id()), &H5Tclose), space(H5Dget_space(rows_.id()), &H5Sclose);
    done_ = done;
    return type_ && H5Tequal(type.id(), type_.id()) > 0 &&
           H5Sget_simple_extent_dims(space.id(), &in_file_, nullptr) == 1 && done_ <= in_file_;
  }

  /// Appends values to the pending rows, in the order of the columns.
  template <class... Values>
  void put(Values... values) {
    (pending_.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  }
  void put_all(const double* values, std::size_t count) {
    pending_.append(reinterpret_cast<const char*>(values), count * sizeof(double));
  }
  void put_text(std::string_view text, std::size_t size) {
    pending_.append(text).append(size - text.size(), '\0');
  }

  /// Writes the pending rows, if there are at least `least`.
  bool write(std::size_t least = 1) {
    const hsize_t count = pending_.size() / type_.size(), end = done_ + count;
    if (count < least) return true;
    if (end > in_file_ && H5Dset_extent(rows_.id(), &end) < 0) return false;
    in_file_ = (std::max)(in_file_, end);
    const hdf5_handle space(H5Dget_space(rows_.id()), &H5Sclose),
        memory(H5Screate_simple(1, &count, nullptr), &H5Sclose);
    if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &done_, nullptr, &count, nullptr) < 0 ||
        H5Dwrite(rows_.id(), type_.id(), memory.id(), space.id(), H5P_DEFAULT, pending_.data()) < 0)
      return false;
    pending_.clear();
    done_ = end;
    return true;
  }

  bool write_chunk() { return write(chunk_rows_); }

  hid_t id() const { return rows_.id(); }
  hsize_t done() const { return done_; } ///< the number of rows written
  /// Discards rows of an interrupted study after the last one written.
  bool truncate() { return in_file_ <= done_ || H5Dset_extent(rows_.id(), &done_) >= 0; }
  bool close() { return rows_.close(); }
  void abandon() { rows_.release(); }

private:
  std::string name_;
  row_type type_;
  hdf5_handle rows_{};
  std::size_t chunk_rows_;
  std::string pending_{};
  hsize_t done_ = 0, in_file_ = 0; ///< the file of an interrupted study may have more rows
};

/// The datasets of a study.
class study_tables {
  static constexpr std::size_t cause_bytes = 512;

public:
  explicit study_tables(const study_layout& layout)
      : layout_(layout),
        runs_("runs", {{{layout.columns[0], H5T_NATIVE_UINT64}, {layout.columns[1], H5T_NATIVE_UINT8}},
                       std::span(layout.columns).subspan(2)}),
        failures_("failures", columns_of_failures(layout.state)),
        samples_("samples", {{{{unlike(layout.samples, "run")}, H5T_NATIVE_UINT64}}, layout.samples}),
        events_("events", {{{{"run"}, H5T_NATIVE_UINT64},
                            {{"t", "s"}, H5T_NATIVE_DOUBLE},
                            {{"event"}, H5T_NATIVE_UINT32}}}) {}

  /// Calls a function of each table until one returns false.
  template <class Function>
  bool for_all(const Function& call) {
    return call(runs_) && call(failures_) && (layout_.samples.empty() || call(samples_)) &&
           (layout_.events.empty() || call(events_));
  }

  bool create(hid_t file, int compression) {
    const std::vector<std::string> ends{"reached_end", "stopped_by_event", "failed"};
    return for_all([&](growing_table& each) { return each.create(file, compression); }) &&
           write_attribute(file, "study", layout_.study) &&
           write_attribute(file, "planned_runs", layout_.runs) && write_constants(file) &&
           write_attribute(runs_.id(), "varied", layout_.varied) &&
           write_attribute(runs_.id(), "ends", ends) &&
           (layout_.events.empty() || write_attribute(events_.id(), "names", layout_.events));
  }

  void put(const finished_run& run) {
    const std::uint64_t number = run.run;
    runs_.put(number, static_cast<std::uint8_t>(run.end));
    runs_.put_all(run.values.data() + 2, run.values.size() - 2);
    if (run.has_failed()) {
      failures_.put(number, run.time);
      std::vector<double> state = run.state; // empty if a function threw an exception
      state.resize(layout_.state.size(), std::numeric_limits<double>::quiet_NaN());
      failures_.put_all(state.data(), state.size());
      failures_.put_text(shortened(run.failure), cause_bytes);
    }
    for (std::size_t i = 0; i < run.samples.size(); i += layout_.samples.size()) {
      samples_.put(number);
      samples_.put_all(run.samples.data() + i, layout_.samples.size());
    }
    for (const auto& [which, when] : run.events) events_.put(number, when, which);
  }

private:
  static row_type columns_of_failures(const std::vector<column_label>& state) {
    row_type all(
        {{{unlike(state, "run")}, H5T_NATIVE_UINT64}, {{unlike(state, "t_end"), "s"}, H5T_NATIVE_DOUBLE}},
        state);
    all.add({unlike(state, "cause")}, text_type(cause_bytes).id());
    return all;
  }

  bool write_constants(hid_t file) const {
    row_type names;
    std::vector<double> values;
    for (const auto& [what, value] : layout_.constants) {
      names.add(what, H5T_NATIVE_DOUBLE);
      values.push_back(value);
    }
    return values.empty() || (names && write_attribute(file, "constants", names.id(), values.data()) &&
                              write_attribute(file, "units_of_constants", names.units()));
  }

  static std::string unlike(const std::vector<column_label>& others, std::string name) {
    while (std::ranges::find(others, name, &column_label::name) != others.end()) name += '_';
    return name;
  }
  /// Returns as much of a sentence as fits, cut between UTF-8 characters.
  static std::string shortened(const std::string& text) {
    constexpr std::string_view dots = "\xE2\x80\xA6";
    if (text.size() <= cause_bytes) return text;
    std::size_t end = cause_bytes - dots.size();
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return text.substr(0, end).append(dots);
  }

  study_layout layout_;
  growing_table runs_, failures_, samples_, events_;
};

} // namespace kanexpr::ensembles
