#pragma once

#include <kanexpr/base/outcome.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace kanexpr::exporting {

struct file_text {
  std::filesystem::path path{};
  std::string text{};
};

/// Writes all of the files or none of them: each first under another name.
inline outcome write_files(const std::vector<file_text>& files) {
  const auto beside = [](const file_text& f) {
    std::filesystem::path other = f.path;
    return other += ".part";
  };
  std::vector<std::filesystem::path> written;
  const auto give_up = [&](const std::filesystem::path& at) {
    std::error_code ignored;
    for (const std::filesystem::path& done : written) std::filesystem::remove(done, ignored);
    for (const file_text& f : files) std::filesystem::remove(beside(f), ignored);
    return outcome(at.string() + " cannot be written");
  };
  for (const file_text& f : files) {
    std::error_code failed;
    if (f.path.has_parent_path()) std::filesystem::create_directories(f.path.parent_path(), failed);
    std::ofstream to(beside(f), std::ios::binary);
    to << f.text;
    to.close();
    if (failed || !to) return give_up(f.path);
  }
  for (const file_text& f : files) {
    std::error_code failed;
    std::filesystem::rename(beside(f), f.path, failed);
    if (failed) return give_up(f.path);
    written.push_back(f.path);
  }
  return {};
}

} // namespace kanexpr::exporting
