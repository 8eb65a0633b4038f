#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/exporting/files.hpp>
#include <kanexpr/exporting/shell.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace kanexpr::exporting {

/// A shared library for the host machine, compiled from C sources.
struct library {
  std::string bytes{};
  std::string note{};    ///< the reason why no library can be built here, if none can
  std::string mistake{}; ///< the reason why the library could not be compiled

  static std::string ending() { return is_apple ? ".dylib" : ".so"; }

  /// The FMI name of the platform; empty if FMI defines none.
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

/// Compiles files with the shell command `compiler`; their paths must not contain folders.
inline library compiled_library(const std::string& name, const std::vector<file_text>& files,
                                const std::string& compiler) {
  if (library::platform().empty())
    return {.note = "contains only sources, because kanexpr cannot compile a library for this platform"};
  if (compiler.empty()) return {.note = "contains only sources, because no compiler is specified"};
  if (std::system(("command -v " + compiler + " >/dev/null 2>&1").c_str()) != 0)
    return {.note = "contains only sources, because there is no compiler " + compiler};
  const temporary_folder folder;
  if (folder.path().empty()) return {.mistake = "the temporary folder for compilation cannot be created"};
  const std::string made = (folder.path() / (name + library::ending())).string();
  std::string command = compiler + " -std=c99 -O2 -fno-math-errno -fvisibility=hidden -fPIC -shared -s -o " +
                        shell_quoted(made);
  std::vector<file_text> there = files;
  for (file_text& each : there) {
    each.path = folder.path() / each.path;
    if (each.path.extension() == ".c") command += ' ' + shell_quoted(each.path.string());
  }
  if (const outcome written = write_files(there); !written) return {.mistake = written.cause()};
  if (std::system((command + " -lm").c_str()) != 0)
    return {.mistake = name + " does not compile as C; " + compiler + " reports the errors"};
  std::ifstream from(made, std::ios::binary);
  return {.bytes = {std::istreambuf_iterator<char>(from), {}}};
}

} // namespace kanexpr::exporting
