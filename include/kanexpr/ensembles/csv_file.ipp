#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/atomic_file.hpp>
#include <kanexpr/ensembles/csv_file.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace kanexpr {

namespace ensembles {

class csv_results final : public results_file {
public:
  csv_results(std::string path, const csv_options& options) : path_(std::move(path)), options_(options) {}

  outcome fits(const study_layout& layout) const override {
    if (layout.samples.empty() && layout.events.empty()) return {};
    return outcome(path_ + " cannot hold the " + (layout.samples.empty() ? "events" : "trajectories") +
                   " that the study keeps; use an HDF5 file");
  }

  outcome begin(const study_layout& layout) override {
    out_ = std::ofstream(path_, std::ios::binary);
    if (!out_) return file_failure(path_, "cannot be opened");
    rows_ = 0;
    std::vector<std::string> names;
    names.reserve(layout.columns.size());
    const bool has_units = options_.with_units && layout.has_units();
    for (const auto& [name, unit] : layout.columns)
      names.push_back(simulations::header(name, has_units ? unit : ""));
    writer_.emplace(out_, names, path_);
    return state();
  }

  outcome resume(const study_layout& layout, const std::string& position) override {
    std::uint64_t size = 0;
    loader reported(position);
    reported(size, rows_);
    std::error_code error;
    if (const auto found = std::filesystem::file_size(path_, error); error || found < size)
      return outcome(path_ + " has changed since the checkpoint was written");
    std::filesystem::resize_file(path_, size, error);
    out_ = std::ofstream(path_, std::ios::binary | std::ios::app | std::ios::ate);
    if (error || !out_) return file_failure(path_, "cannot be opened");
    writer_.emplace(csv_writer::resume(out_, rows_, layout.columns.size(), path_));
    return {};
  }

  outcome take(const finished_run& run) override {
    ++rows_;
    writer_->row(run.values);
    return state();
  }

  outcome flush(std::string& position) override {
    if (!writer_->finish()) return state();
    saver report;
    report(static_cast<std::uint64_t>(out_.tellp()), rows_);
    position = report.bytes();
    return store(path_, path_);
  }

  outcome end() override {
    writer_->finish();
    out_.close();
    return out_ || !*writer_ ? state()
                             : outcome("writing " + path_ + " failed while the file was being closed");
  }

private:
  outcome state() const { return *writer_ ? outcome() : outcome(writer_->cause()); }

  const std::string path_;
  const csv_options options_;
  std::ofstream out_{};
  std::optional<csv_writer> writer_{};
  std::size_t rows_ = 0;
};

} // namespace ensembles

KANEXPR_ENSEMBLES std::shared_ptr<results_file> csv_file(const file_path& path, const csv_options& options) {
  return std::make_shared<ensembles::csv_results>(path.text(), options);
}

} // namespace kanexpr
