#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensemble/hdf5/engine/disk.hpp>
#include <kanexpr/ensemble/hdf5/engine/errors.hpp>
#include <kanexpr/ensemble/hdf5/engine/study_tables.hpp>
#include <kanexpr/ensemble/hdf5/hdf5_file.hpp>
#include <kanexpr/ensemble/held_file.hpp>
#include <kanexpr/ensemble/sum_of_bytes.hpp>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <unistd.h>

namespace kanexpr {

namespace ensembles {

/// It is written as HDF5 writes for others to read meanwhile: nothing on the disk refers to what is not there
/// yet. So the file is sound wherever this program ends. Rows behind a checkpoint are written once more, as
/// they were.
class hdf5_results final : public results_file {
  using clock = std::chrono::steady_clock;

public:
  hdf5_results(std::string path, const hdf5_options& options) : path_(std::move(path)), options_(options) {}
  ~hdf5_results() override { static_cast<void>(finish()); }

  std::string path() const override { return path_; }

  outcome begin(const study_layout& layout) override {
    const hdf5_errors errors;
    restart(layout);
    if (path_.empty()) return outcome("the path of the file is empty");
    if (outcome fits = check_replaceable(path_, "a file"); !fits) return fits;
    if (outcome claimed = held_.claim(path_); !claimed) return claimed;
    const std::string end = end_of_links(path_), beside = end + ".new";
    const bool is_sound = create(beside);
    if (is_sound && std::rename(beside.c_str(), end.c_str()) == 0) return held_.hold(path_);
    outcome failed = is_sound
                         ? outcome(path_ + " cannot be replaced: " + std::generic_category().message(errno))
                         : not_written(errors);
    abandon();
    ::unlink(beside.c_str());
    return failed;
  }

  outcome go_on(const study_layout& layout, const std::string& position) override {
    const hdf5_errors errors;
    restart(layout);
    if (outcome claimed = held_.claim(path_); !claimed) return claimed;
    if (outcome fits = check_content(errors); !fits) return fits;
    if (!open(H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE) || H5Fincrement_filesize(file_.id(), 0) < 0 ||
        !tables_->open(file_.id())) {
      abandon();
      return not_opened(errors);
    }
    if (outcome holds = check_rows(position); !holds) {
      abandon();
      return holds;
    }
    return held_.hold(path_);
  }

  outcome take(const finished_run& run) override {
    if (!failure_) return failure_;
    tables_->take(run);
    const std::chrono::duration<double> waited = clock::now() - flushed_;
    const bool flushes = waited.count() >= options_.flush_every;
    if (!flushes && !tables_->has_many_waiting()) return {};
    const hdf5_errors errors;
    const bool is_sound = flushes ? flush() : tables_->write() && !disk_.has_failed();
    return is_sound ? outcome() : fail(errors);
  }

  outcome flush(std::string& position) override {
    const hdf5_errors errors;
    if (!failure_) return failure_;
    if (!flush()) return fail(errors);
    bytes_writer told;
    for (const auto& each : tables_->all()) {
      const std::optional<std::string> last = each.rows->last();
      if (!last) return fail(errors);
      told.put(each.rows->done()), told.put(sum_of(*last));
    }
    position = told.bytes();
    return held_.store();
  }

  outcome end() override {
    outcome done = finish();
    return failure_ ? done : failure_;
  }

private:
  void restart(const study_layout& layout) {
    static_cast<void>(finish());
    failure_ = outcome();
    tables_.emplace(layout);
    flushed_ = clock::now();
  }

  /// How files are opened: also those that a program left open when it ended, as the command h5clear does.
  hdf5_handle access() {
    hdf5_handle how(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
    const hbool_t yes = true;
    if (!disk_.use(how.id()) || H5Pset_libver_bounds(how.id(), H5F_LIBVER_V110, H5F_LIBVER_V110) < 0 ||
        H5Pset(how.id(), "clear_status_flags", &yes) < 0 || H5Pset(how.id(), "skip_eof_check", &yes) < 0)
      return {};
    return how;
  }

  bool create(const std::string& path) {
    const hdf5_handle how = access(), what(H5Pcreate(H5P_FILE_CREATE), &H5Pclose);
    if (!how || H5Pset_obj_track_times(what.id(), false) < 0) return false;
    file_ = {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, what.id(), how.id()), &H5Fclose};
    return file_ && tables_->create(file_.id(), options_.compression) &&
           H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0 && H5Fstart_swmr_write(file_.id()) >= 0 &&
           !disk_.has_failed();
  }

  bool open(unsigned how) {
    const hdf5_handle by = access();
    if (by) file_ = {H5Fopen(path_.c_str(), how, by.id()), &H5Fclose};
    return by && file_;
  }

  /// Before anything in it is changed.
  outcome check_content(const hdf5_errors& errors) {
    const htri_t is_hdf5 = H5Fis_hdf5(path_.c_str());
    if (is_hdf5 == 0) return outcome(path_ + " is not a file of HDF5");
    if (is_hdf5 < 0 || !open(H5F_ACC_RDONLY)) return not_opened(errors);
    const bool fits = tables_->open(file_.id());
    close();
    return fits ? outcome() : outcome(path_ + " does not have the columns of the study");
  }

  /// Whether the rows are there that the study had noted: those of another one may have the same columns, and
  /// a file that was cut off is filled up with zeros.
  outcome check_rows(const std::string& position) {
    bytes_reader told(position);
    for (const auto& each : tables_->all()) {
      const auto done = told.get<std::size_t>();
      const auto sum = told.get<std::uint64_t>();
      if (done > each.rows->in_file())
        return outcome(path_ + " has fewer rows in " + each.name + " than when the study was noted");
      each.rows->go_on(done);
      const std::optional<std::string> last = each.rows->last();
      if (done > 0 && (!last || sum_of(*last) != sum))
        return outcome(path_ + " does not hold what it held when the study was noted");
    }
    return {};
  }

  bool flush() {
    flushed_ = clock::now();
    return tables_->write() && H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0 && !disk_.has_failed();
  }

  outcome finish() {
    const hdf5_errors errors;
    if (!file_) return {};
    if (!flush()) return fail(errors);
    // What was written behind the end of an interrupted study, and not once more.
    for (const auto& each : tables_->all()) {
      const hsize_t done = each.rows->done();
      if (each.rows->in_file() > done && H5Dset_extent(each.rows->id(), &done) < 0) return fail(errors);
    }
    if (!close() || disk_.has_failed()) return fail(errors);
    held_.release();
    return {};
  }

  bool close() {
    bool is_closed = true;
    for (const auto& each : tables_->all()) is_closed &= each.rows->close();
    return file_.close() && is_closed;
  }

  outcome fail(const hdf5_errors& errors) {
    failure_ = not_written(errors);
    abandon();
    return failure_;
  }

  /// Ends without the rows that wait.
  void abandon() {
    close();
    held_.release();
  }

  outcome not_written(const hdf5_errors& errors) const {
    return outcome(path_ + " cannot be written: " + cause(errors));
  }
  outcome not_opened(const hdf5_errors& errors) const {
    return outcome(path_ + " cannot be opened: " + cause(errors));
  }
  std::string cause(const hdf5_errors& errors) const {
    return disk_.has_failed() ? disk_.failure() : errors.first();
  }

  const std::string path_;
  const hdf5_options options_;
  disk disk_{};
  hdf5_handle file_{};
  std::optional<study_tables> tables_{};
  held_file held_{};
  outcome failure_{};
  clock::time_point flushed_{};
};

} // namespace ensembles

KANEXPR_HDF5 std::shared_ptr<results_file> hdf5_file(const file_path& path, const hdf5_options& options) {
  return std::make_shared<ensembles::hdf5_results>(path.text(), options);
}

} // namespace kanexpr
