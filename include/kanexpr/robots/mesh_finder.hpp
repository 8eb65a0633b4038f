#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace kanexpr::robots {

/// Finds the files that a robot description refers to. A ROS package is a folder next to or above the
/// description, or any folder that contains the description, whatever its name.
class mesh_finder {
public:
  /// `folder` contains the description; if `folder` is empty, no files are found.
  explicit mesh_finder(const std::string& folder) {
    std::error_code failed;
    if (!folder.empty()) folder_ = std::filesystem::weakly_canonical(folder, failed);
  }

  /// The absolute path of the folder of the description.
  std::string folder() const { return folder_.generic_string(); }

  /// The path of a file relative to the folder of the description, or the absolute path if the description
  /// specifies one.
  std::optional<std::string> find(std::string_view named) const {
    if (folder_.empty() || named.empty()) return {};
    for (std::string_view scheme : {"package://", "model://"})
      if (named.starts_with(scheme)) return find_in_package(named.substr(scheme.size()));
    if (named.starts_with("file://")) named.remove_prefix(std::string_view("file://").size());
    if (!is_file(folder_ / named)) return {};
    return std::filesystem::path(named).generic_string();
  }

private:
  std::optional<std::string> find_in_package(std::string_view named) const {
    named.remove_prefix((std::min)(named.find_first_not_of('/'), named.size()));
    const std::size_t slash = named.find('/');
    if (slash == named.npos) return {};
    for (std::string_view below : {named, named.substr(slash + 1)})
      for (std::filesystem::path in = folder_;; in = in.parent_path()) {
        if (is_file(in / below))
          return (in / below).lexically_normal().lexically_relative(folder_).generic_string();
        if (in == in.parent_path()) break;
      }
    return {};
  }

  static bool is_file(const std::filesystem::path& path) {
    std::error_code failed;
    return std::filesystem::is_regular_file(path, failed);
  }

  std::filesystem::path folder_{};
};

} // namespace kanexpr::robots
