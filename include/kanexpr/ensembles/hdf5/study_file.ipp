#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/atomic_file.hpp>
#include <kanexpr/ensembles/hdf5/hdf5_file.hpp>
#include <kanexpr/ensembles/hdf5/tables.ipp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace kanexpr {

namespace ensembles {

/// Writes in HDF5's SWMR mode, in which no metadata on the disk refers to data that has not been written yet.
/// Therefore, the file is readable no matter when the program ends, and a study resumes by overwriting the
/// rows after its checkpoint.
class hdf5_results final : public results_file {
  using clock = std::chrono::steady_clock;

public:
  hdf5_results(const std::string& path, const hdf5_options& options) : path_(path), options_(options) {}
  ~hdf5_results() override { static_cast<void>(finish()); }

  outcome begin(const study_layout& layout) override {
    const hdf5_errors errors;
    if (outcome prepared = prepare(layout); !prepared) return prepared;
    if (create(path_.replacement())) {
      outcome replaced = path_.replace();
      return replaced ? outcome() : fail(replaced);
    }
    path_.discard_replacement();
    return fail(errors);
  }

  outcome resume(const study_layout& layout, const std::string& position) override {
    const hdf5_errors errors;
    if (outcome prepared = prepare(layout); !prepared) return prepared;
    std::error_code missing;
    std::uint64_t size = 0;
    loader reported(position);
    reported(size);
    // HDF5 would read the missing part of a truncated file as zeros.
    const bool is_whole = std::filesystem::file_size(path_.target(), missing) >= size || missing;
    if (is_whole && open() && tables_->for_all([&](growing_table& each) {
          hsize_t done = 0;
          reported(done);
          return reported && each.open(file_.id(), done);
        }))
      return {};
    close();
    return outcome(path_.path() + (errors.first().empty() ? " has changed since the checkpoint was written"
                                                          : " cannot be opened: " + errors.first()));
  }

  outcome take(const finished_run& run) override {
    if (!failure_) return failure_;
    tables_->put(run);
    const std::chrono::duration<double> since = clock::now() - flushed_;
    const hdf5_errors errors;
    const bool is_written = since.count() >= options_.flush_every ? flush() : write_chunks();
    return is_written ? outcome() : fail(errors);
  }

  outcome flush(std::string& position) override {
    const hdf5_errors errors;
    if (!failure_) return failure_;
    if (!flush()) return fail(errors);
    saver report;
    report(std::uint64_t{std::filesystem::file_size(path_.target())});
    tables_->for_all([&](const growing_table& each) { return report(each.done()), true; });
    position = report.bytes();
    return store(path_.target(), path_.path());
  }

  outcome end() override {
    outcome done = finish();
    return failure_ ? done : failure_;
  }

private:
  outcome prepare(const study_layout& layout) {
    static_cast<void>(finish());
    failure_ = outcome();
    tables_.emplace(layout);
    flushed_ = clock::now();
    return path_.check_target();
  }

  /// Allows files to be opened even if their writer was killed, as the command h5clear does.
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
  bool open() {
    const hdf5_handle how = access();
    if (how)
      file_ = {H5Fopen(path_.target().c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, how.id()), &H5Fclose};
    return file_ && H5Fincrement_filesize(file_.id(), 0) >= 0;
  }

  bool write_chunks() {
    return tables_->for_all([](growing_table& each) { return each.write_chunk(); });
  }
  bool flush() {
    flushed_ = clock::now();
    return tables_->for_all([](growing_table& each) { return each.write(); }) &&
           H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0;
  }

  outcome finish() {
    const hdf5_errors errors;
    const bool is_done =
        !file_ ||
        (flush() && tables_->for_all([](growing_table& each) { return each.truncate(); }) && close());
    return is_done ? outcome() : fail(errors);
  }
  bool close() {
    return tables_->for_all([](growing_table& each) { return each.close(); }) && file_.close();
  }

  outcome fail(const hdf5_errors& errors) {
    return fail(outcome(path_.path() + " cannot be written: " + errors.first()));
  }
  /// Leaves the file as it is. HDF5 would try to write the rest when it closes a file, so it is not closed.
  outcome fail(outcome why) {
    failure_ = std::move(why);
    tables_->for_all([](growing_table& each) { return each.abandon(), true; });
    file_.release();
    return failure_;
  }

  const atomic_file path_;
  const hdf5_options options_;
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
