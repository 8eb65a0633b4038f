#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/content_hash.hpp>
#include <kanexpr/ensembles/exclusive_file.hpp>
#include <kanexpr/ensembles/hdf5/errors.ipp>
#include <kanexpr/ensembles/hdf5/hdf5_file.hpp>
#include <kanexpr/ensembles/hdf5/study_tables.ipp>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace kanexpr {

namespace ensembles {

/// Written in HDF5's SWMR mode, in which no metadata on the disk refers to data that is not there yet. So the
/// file is readable wherever the program ends, and a study resumes by overwriting the rows after its
/// checkpoint.
class hdf5_results final : public results_file {
  using clock = std::chrono::steady_clock;

public:
  hdf5_results(std::string path, const hdf5_options& options) : path_(std::move(path)), options_(options) {}
  ~hdf5_results() override { static_cast<void>(finish()); }

  outcome begin(const study_layout& layout) override {
    const hdf5_errors errors;
    if (outcome claimed = claim(layout); !claimed) return claimed;
    if (create(exclusive_.replacement())) {
      outcome replaced = exclusive_.replace();
      return replaced ? outcome() : fail(replaced);
    }
    outcome failed = fail(errors);
    ::unlink(exclusive_.replacement().c_str());
    return failed;
  }

  outcome resume(const study_layout& layout, const std::string& position) override {
    const hdf5_errors errors;
    if (outcome claimed = claim(layout); !claimed) return claimed;
    if (!has_rows(position)) {
      close();
      exclusive_.release();
      return outcome(path_ + (errors.first().empty() ? " has changed since the checkpoint was written"
                                                     : " cannot be opened: " + errors.first()));
    }
    close();
    const bool is_open = open(H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE) &&
                         H5Fincrement_filesize(file_.id(), 0) >= 0 && tables_->open(file_.id());
    if (!is_open) return fail(outcome(path_ + " cannot be opened: " + errors.first()));
    loader reported(position);
    tables_->for_all([&](growing_rows& rows) { return resume_rows(rows, reported); });
    return {};
  }

  outcome take(const finished_run& run) override {
    if (!failure_) return failure_;
    tables_->put(run);
    const std::chrono::duration<double> since = clock::now() - flushed_;
    const bool must_flush = since.count() >= options_.flush_every;
    const bool may_wait = tables_->for_all([](const growing_rows& each) { return !each.fills_chunk(); });
    if (may_wait && !must_flush) return {};
    const hdf5_errors errors;
    return (must_flush ? flush() : write()) ? outcome() : fail(errors);
  }

  outcome flush(std::string& position) override {
    const hdf5_errors errors;
    if (!failure_) return failure_;
    saver report;
    const auto describe = [&](const growing_rows& rows) {
      const std::optional<std::string> last = rows.last();
      if (last) report(rows.done(), content_hash(*last));
      return last.has_value();
    };
    if (!flush() || !tables_->for_all(describe)) return fail(errors);
    position = report.bytes();
    return exclusive_.sync(exclusive_.target());
  }

  outcome end() override {
    outcome done = finish();
    return failure_ ? done : failure_;
  }

private:
  outcome claim(const study_layout& layout) {
    static_cast<void>(finish());
    failure_ = outcome();
    tables_.emplace(layout);
    flushed_ = clock::now();
    if (path_.empty()) return outcome("the path of the file is empty");
    if (outcome claimed = exclusive_.claim(path_); !claimed) return claimed;
    return exclusive_.check_replaceable("a file");
  }

  /// Opens files also after their writer was killed, as the command h5clear does.
  static hdf5_handle access() {
    hdf5_handle how(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
    const hbool_t yes = true;
    if (H5Pset_libver_bounds(how.id(), H5F_LIBVER_V110, H5F_LIBVER_V110) < 0 ||
        H5Pset(how.id(), "clear_status_flags", &yes) < 0 || H5Pset(how.id(), "skip_eof_check", &yes) < 0)
      return {};
    return how;
  }

  bool create(const std::string& path) {
    const hdf5_handle how = access(), what(H5Pcreate(H5P_FILE_CREATE), &H5Pclose);
    if (!how || H5Pset_obj_track_times(what.id(), false) < 0) return false;
    file_ = {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, what.id(), how.id()), &H5Fclose};
    return file_ && tables_->create(file_.id(), options_.compression) &&
           H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0 && H5Fstart_swmr_write(file_.id()) >= 0;
  }
  bool open(unsigned how) {
    const hdf5_handle by = access();
    if (by) file_ = {H5Fopen(exclusive_.target().c_str(), how, by.id()), &H5Fclose};
    return static_cast<bool>(file_);
  }

  /// True if the file holds the rows that a checkpoint reported. Checked before anything in the file changes:
  /// another study may have the same columns, and a truncated file is read as zeros.
  bool has_rows(const std::string& position) {
    loader reported(position);
    return open(H5F_ACC_RDONLY) && tables_->open(file_.id()) &&
           tables_->for_all([&](growing_rows& rows) { return resume_rows(rows, reported); });
  }
  static bool resume_rows(growing_rows& rows, loader& reported) {
    hsize_t done = 0;
    std::uint64_t hash = 0;
    reported(done, hash);
    rows.resume_at(done);
    const std::optional<std::string> last = rows.has_done() ? rows.last() : std::nullopt;
    return reported && last && content_hash(*last) == hash;
  }

  bool write() {
    return tables_->for_all([](growing_rows& each) { return each.write(); });
  }
  bool flush() {
    flushed_ = clock::now();
    return write() && H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0;
  }

  outcome finish() {
    const hdf5_errors errors;
    if (!file_) return {};
    if (!flush() || !tables_->for_all([](growing_rows& each) { return each.truncate(); }) || !close())
      return fail(errors);
    exclusive_.release();
    return {};
  }
  bool close() {
    return tables_->for_all([](growing_rows& each) { return each.close(); }) && file_.close();
  }

  outcome fail(const hdf5_errors& errors) {
    return fail(outcome(path_ + " cannot be written: " + errors.first()));
  }
  /// Leaves the file as it is. HDF5 would try to write the rest when it closes a file, so it is not closed.
  outcome fail(outcome why) {
    failure_ = std::move(why);
    tables_->for_all([](growing_rows& each) { return each.abandon(), true; });
    file_.release();
    exclusive_.release();
    return failure_;
  }

  const std::string path_;
  const hdf5_options options_;
  exclusive_file exclusive_{};
  hdf5_handle file_{};
  std::optional<study_tables> tables_{};
  outcome failure_{};
  clock::time_point flushed_{};
};

} // namespace ensembles

KANEXPR_HDF5 std::shared_ptr<results_file> hdf5_file(const file_path& path, const hdf5_options& options) {
  H5dont_atexit();
  return std::make_shared<ensembles::hdf5_results>(path.text(), options);
}

} // namespace kanexpr
