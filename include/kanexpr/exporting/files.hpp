#pragma once

#include <kanexpr/base/outcome.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

struct file_text {
  std::filesystem::path path{};
  std::string text{};
};

namespace detail {

/// An unused file name next to `file`.
inline std::filesystem::path unused_name_next_to(const std::filesystem::path& file) {
  for (int i = 1;; ++i) {
    std::filesystem::path other = file;
    other += "." + std::to_string(i) + ".part";
    std::error_code unknown;
    if (!std::filesystem::exists(std::filesystem::symlink_status(other, unknown))) return other;
  }
}

/// Records the files and folders that were created or moved, so that the changes can be undone.
class file_transaction {
public:
  using path = std::filesystem::path;

  /// Creates the missing parent folders of a file.
  void create_folders(const path& file) {
    path folder;
    std::error_code failed;
    for (const path& part : file.parent_path()) {
      folder /= part;
      if (!std::filesystem::exists(folder, failed) && std::filesystem::create_directory(folder, failed))
        made_.push_back(folder);
    }
  }

  /// Writes a text to a temporary file next to its target.
  bool write(const file_text& f) {
    const path part = unused_name_next_to(f.path);
    std::ofstream to(part, std::ios::binary);
    to << f.text;
    to.close();
    written_.push_back(part);
    std::error_code unknown;
    return to && !std::filesystem::is_directory(f.path, unknown);
  }

  /// Moves temporary file `i` to its target; an existing file is moved aside first.
  bool move_into_place(std::size_t i, const path& file) {
    std::error_code failed;
    if (std::filesystem::exists(std::filesystem::symlink_status(file, failed))) {
      const path before = unused_name_next_to(file);
      std::filesystem::rename(file, before, failed);
      if (failed) return false;
      replaced_.emplace_back(before, file);
    }
    std::filesystem::rename(written_[i], file, failed);
    if (!failed) made_.push_back(file);
    return !failed;
  }

  void commit() {
    std::error_code ignored;
    for (const auto& [before, file] : replaced_) std::filesystem::remove(before, ignored);
  }

  void roll_back() {
    std::error_code ignored;
    for (const path& part : written_) std::filesystem::remove(part, ignored);
    for (; !made_.empty(); made_.pop_back()) std::filesystem::remove(made_.back(), ignored);
    for (const auto& [before, file] : replaced_) std::filesystem::rename(before, file, ignored);
  }

private:
  std::vector<path> written_{}, made_{};
  std::vector<std::pair<path, path>> replaced_{};
};

} // namespace detail

/// Writes all of the files or none of them; each is first written under a temporary name. If one cannot be
/// written, the previous files are restored.
inline outcome write_files(const std::vector<file_text>& files) {
  detail::file_transaction changes;
  const auto give_up = [&](const std::filesystem::path& at) {
    changes.roll_back();
    return outcome(at.string() + " cannot be written");
  };
  for (const file_text& f : files) {
    changes.create_folders(f.path);
    if (!changes.write(f)) return give_up(f.path);
  }
  for (std::size_t i = 0; i < files.size(); ++i)
    if (!changes.move_into_place(i, files[i].path)) return give_up(files[i].path);
  changes.commit();
  return {};
}

} // namespace kanexpr::exporting
