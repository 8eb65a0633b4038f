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

/// Writes all of the files or none of them: each first under another name. What was there before stays where
/// none can be written.
inline outcome write_files(const std::vector<file_text>& files) {
  namespace fs = std::filesystem;
  const auto beside = [](const file_text& f) {
    fs::path other = f.path;
    return other += ".part";
  };
  std::vector<fs::path> made; // files, and folders behind those around them
  const auto give_up = [&](const fs::path& at) {
    std::error_code ignored;
    for (const file_text& f : files) fs::remove(beside(f), ignored);
    for (; !made.empty(); made.pop_back()) fs::remove(made.back(), ignored);
    return outcome(at.string() + " cannot be written");
  };
  for (const file_text& f : files) {
    std::error_code failed;
    fs::path folder;
    for (const fs::path& part : f.path.parent_path()) {
      folder /= part;
      if (!fs::exists(folder, failed) && fs::create_directory(folder, failed)) made.push_back(folder);
    }
    std::ofstream to(beside(f), std::ios::binary);
    to << f.text;
    to.close();
    if (!to || fs::is_directory(f.path, failed)) return give_up(f.path);
  }
  for (const file_text& f : files) {
    std::error_code failed;
    fs::rename(beside(f), f.path, failed);
    if (failed) return give_up(f.path);
    made.push_back(f.path);
  }
  return {};
}

} // namespace kanexpr::exporting
