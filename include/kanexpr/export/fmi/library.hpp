#pragma once

#include <kanexpr/export/files.hpp>
#include <kanexpr/export/shell.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace kanexpr::exporting {

/// Sources of C as a library of the machine that one works on.
struct library {
  std::string bytes{};
  std::string note{};    ///< why there is none, where none can be had
  std::string mistake{}; ///< why it could not be compiled

  static std::string ending() { return is_apple ? ".dylib" : ".so"; }

  /// As FMI calls it; empty: it knows none.
  static std::string platform() {
    const std::string system = is_apple ? "-darwin" : "-linux";
    if (!has_shell || (!is_apple && !is_linux)) return {};
#if defined(__x86_64__)
    return "x86_64" + system;
#elif defined(__aarch64__)
    return "aarch64" + system;
#else
    return {};
#endif
  }

private:
#ifdef __APPLE__
  static constexpr bool is_apple = true;
#else
  static constexpr bool is_apple = false;
#endif
#ifdef __linux__
  static constexpr bool is_linux = true;
#else
  static constexpr bool is_linux = false;
#endif
};

/// Compiled by what a shell calls `compiler`. No file has a folder.
inline library compiled_library(const std::string& name, const std::vector<file_text>& files,
                                const std::string& compiler) {
  if (library::platform().empty())
    return {.note = "holds sources alone, as kanexpr compiles no library for this system"};
  if (compiler.empty()) return {.note = "holds sources alone, as no compiler is given"};
  if (std::system(("command -v " + compiler + " >/dev/null 2>&1").c_str()) != 0)
    return {.note = "holds sources alone, as there is no compiler " + compiler};
  const temporary_folder folder;
  if (folder.path().empty()) return {.mistake = "no folder can be made to compile in"};
  const std::string made = (folder.path() / (name + library::ending())).string();
  std::string command =
      compiler + " -std=c99 -O2 -fno-math-errno -fvisibility=hidden -fPIC -shared -s -o " + in_quotes(made);
  std::vector<file_text> there = files;
  for (file_text& each : there) {
    each.path = folder.path() / each.path;
    if (each.path.extension() == ".c") command += ' ' + in_quotes(each.path.string());
  }
  if (const outcome written = write_files(there); !written) return {.mistake = written.cause()};
  if (std::system((command + " -lm").c_str()) != 0)
    return {.mistake = name + " does not compile as C; " + compiler + " says why"};
  std::ifstream from(made, std::ios::binary);
  return {.bytes = {std::istreambuf_iterator<char>(from), {}}};
}

} // namespace kanexpr::exporting
