#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensemble/csv_file.hpp>
#include <kanexpr/ensemble/held_file.hpp>
#include <kanexpr/ensemble/sum_of_bytes.hpp>
#include <kanexpr/simulate/csv.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

namespace kanexpr {

namespace ensembles {

class csv_results final : public results_file {
public:
  explicit csv_results(std::string path) : path_(std::move(path)) {}

  std::string path() const override { return path_; }

  outcome fits(const study_layout& layout) const override {
    if (layout.samples.empty() && layout.events.empty()) return {};
    return outcome(path_ + " cannot hold the " + (layout.samples.empty() ? "events" : "trajectories") +
                   " that the study keeps, as it is a table of runs; a file of HDF5 can");
  }

  outcome begin(const study_layout& layout) override {
    if (outcome claimed = held_.claim(path_); !claimed) return claimed;
    out_ = std::ofstream(path_, std::ios::binary);
    if (!out_) return not_opened();
    rows_ = 0;
    writer_.emplace(out_, names(layout), path_);
    return *writer_ ? held_.hold(path_) : outcome(writer_->cause());
  }

  outcome go_on(const study_layout& layout, const std::string& position) override {
    outcome opened = open_behind(layout, position);
    if (!opened) held_.release();
    return opened;
  }

  outcome take(const finished_run& run) override {
    ++rows_;
    return writer_->row(run.values) ? outcome() : outcome(writer_->cause());
  }

  outcome flush(std::string& position) override {
    if (!writer_->finish()) return outcome(writer_->cause());
    bytes_writer told;
    const auto size = static_cast<std::uint64_t>(out_.tellp());
    told.put(size), told.put(rows_);
    told.put(sum_up_to(size)), told.put(path_);
    position = told.bytes();
    return held_.store();
  }

  outcome end() override {
    if (!writer_->finish()) return outcome(writer_->cause());
    out_.close();
    held_.release();
    return out_ ? outcome() : outcome("writing " + path_ + " failed at its end");
  }

private:
  outcome open_behind(const study_layout& layout, const std::string& position) {
    bytes_reader told(position);
    const auto size = told.get<std::uint64_t>();
    rows_ = told.get<std::size_t>();
    const auto sum = told.get<std::uint64_t>();
    const std::string noted_as = told.get_text();
    if (outcome claimed = held_.claim(path_); !claimed) return claimed;
    if (outcome held = held_.hold(path_); !held) return held;
    if (outcome begins = check_header(layout, size); !begins) return begins;
    if (sum_up_to(size) != sum)
      return outcome(path_ + " does not hold what " + (noted_as == path_ ? "it" : noted_as) +
                     " held when the study was noted");
    if (::truncate(path_.c_str(), static_cast<::off_t>(size)) != 0) return not_opened();
    out_ = std::ofstream(path_, std::ios::binary | std::ios::app | std::ios::ate);
    if (!out_) return not_opened();
    writer_.emplace(csv_writer::behind(out_, rows_, layout.columns.size(), path_));
    return {};
  }
  outcome not_opened() const {
    return outcome(path_ + " cannot be opened: " + std::generic_category().message(errno));
  }
  outcome check_header(const study_layout& layout, std::uint64_t size) const {
    std::ostringstream header;
    csv_writer(header, names(layout)).finish();
    if (held_.read(0, header.str().size()) != header.str())
      return outcome(path_ + " does not begin with the columns of the study");
    if (size > 0 && held_.read(size - 1, 1).empty())
      return outcome(path_ + " is shorter than it was when the study was noted");
    return {};
  }
  /// Of what it holds up to there, or of the end of that: the rows of another study are others.
  std::uint64_t sum_up_to(std::uint64_t size) const {
    const std::uint64_t count = (std::min)(size, std::uint64_t{65536});
    return sum_of(held_.read(size - count, static_cast<std::size_t>(count)));
  }
  static std::vector<std::string> names(const study_layout& layout) {
    std::vector<std::string> all;
    all.reserve(layout.columns.size());
    for (const column_label& each : layout.columns) all.push_back(each.name);
    return all;
  }

  const std::string path_;
  std::ofstream out_{};
  std::optional<csv_writer> writer_{};
  std::size_t rows_ = 0;
  held_file held_{};
};

} // namespace ensembles

KANEXPR_ENSEMBLES std::shared_ptr<results_file> csv_file(const file_path& path) {
  return std::make_shared<ensembles::csv_results>(path.text());
}

} // namespace kanexpr
