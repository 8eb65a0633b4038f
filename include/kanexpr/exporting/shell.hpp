#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

/// Access to the shell and the temporary folder of the operating system.
namespace kanexpr::exporting {

/// Quotes a text as one shell argument.
inline std::string shell_quoted(std::string_view text) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return all + "'";
}

#if defined(__unix__) || defined(__APPLE__)
inline constexpr bool has_shell = true;
#else
inline constexpr bool has_shell = false;
#endif

/// A temporary folder that is removed with this object.
class temporary_folder {
public:
  temporary_folder() {
#if defined(__unix__) || defined(__APPLE__)
    std::error_code failed;
    std::string name = (std::filesystem::temp_directory_path(failed) / "kanexpr-export-XXXXXX").string();
    if (!failed && mkdtemp(name.data()) != nullptr) path_ = name;
#endif
  }
  ~temporary_folder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  temporary_folder(const temporary_folder&) = delete;
  temporary_folder& operator=(const temporary_folder&) = delete;

  /// The path; empty if no folder could be created.
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_{};
};

} // namespace kanexpr::exporting
