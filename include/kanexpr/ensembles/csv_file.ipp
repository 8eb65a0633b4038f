#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/content_hash.hpp>
#include <kanexpr/ensembles/csv_file.hpp>
#include <kanexpr/ensembles/exclusive_file.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

namespace ensembles {

class csv_results final : public results_file {
public:
  explicit csv_results(std::string path) : path_(std::move(path)) {}

  outcome fits(const study_layout& layout) const override {
    if (layout.samples.empty() && layout.events.empty()) return {};
    return outcome(path_ + " cannot hold the " + (layout.samples.empty() ? "events" : "trajectories") +
                   " that the study keeps; use an HDF5 file");
  }

  outcome begin(const study_layout& layout) override {
    if (outcome claimed = file_.claim(path_); !claimed) return claimed;
    out_ = std::ofstream(path_, std::ios::binary);
    if (!out_) return file_.failure("cannot be opened");
    rows_ = 0;
    std::vector<std::string> names;
    names.reserve(layout.columns.size());
    for (const column_label& each : layout.columns) names.push_back(each.name);
    writer_.emplace(out_, names, path_);
    return state();
  }

  outcome resume(const study_layout& layout, const std::string& position) override {
    if (outcome claimed = file_.claim(path_); !claimed) return claimed;
    std::uint64_t size = 0, hash = 0;
    loader reported(position);
    reported(size, rows_, hash);
    if (hash_up_to(size) != hash) {
      file_.release();
      return outcome(path_ + " has changed since the checkpoint was written");
    }
    if (::truncate(path_.c_str(), static_cast<::off_t>(size)) != 0) return file_.failure("cannot be opened");
    out_ = std::ofstream(path_, std::ios::binary | std::ios::app | std::ios::ate);
    if (!out_) return file_.failure("cannot be opened");
    writer_.emplace(csv_writer::resume(out_, rows_, layout.columns.size(), path_));
    return {};
  }

  outcome take(const finished_run& run) override {
    ++rows_;
    writer_->row(run.values);
    return state();
  }

  outcome flush(std::string& position) override {
    writer_->finish();
    if (!*writer_) return state();
    saver report;
    const auto size = static_cast<std::uint64_t>(out_.tellp());
    report(size, rows_, hash_up_to(size));
    position = report.bytes();
    return file_.sync(path_);
  }

  outcome end() override {
    writer_->finish();
    out_.close();
    file_.release();
    return out_ || !*writer_ ? state() : outcome("writing " + path_ + " failed at its end");
  }

private:
  outcome state() const { return *writer_ ? outcome() : outcome(writer_->cause()); }

  /// The hash of the last part of the content before this position.
  std::uint64_t hash_up_to(std::uint64_t size) const {
    std::string part((std::min)(size, std::uint64_t{65536}), '\0');
    std::ifstream in(path_, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(size - part.size()));
    in.read(part.data(), static_cast<std::streamsize>(part.size()));
    return content_hash(in ? part : std::string());
  }

  const std::string path_;
  std::ofstream out_{};
  std::optional<csv_writer> writer_{};
  std::size_t rows_ = 0;
  exclusive_file file_{};
};

} // namespace ensembles

KANEXPR_ENSEMBLES std::shared_ptr<results_file> csv_file(const file_path& path) {
  return std::make_shared<ensembles::csv_results>(path.text());
}

} // namespace kanexpr
