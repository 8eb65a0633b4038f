#pragma once

/// Tables as text: a line of names, then a line for each row, with commas between the fields and names in
/// quotes where they need them (RFC 4180). Numbers are the shortest that give the same bits again; nan and
/// inf are numbers. No locale matters.

#include <kanexpr/simulate/csv_reader.hpp>
#include <kanexpr/simulate/csv_writer.hpp>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace kanexpr {

namespace simulated {

/// "run.csv cannot be opened: No such file or directory".
inline outcome not_opened(const std::filesystem::path& path) {
  return outcome(path.string() + " cannot be opened: " + std::generic_category().message(errno));
}

} // namespace simulated

inline outcome write_csv(const table& all, const std::filesystem::path& path) {
  std::ofstream out(path, std::ios::binary);
  if (!out) return simulated::not_opened(path);
  return write_csv(all, out, path.string());
}

inline csv_table read_csv(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return csv_table(simulated::not_opened(path));
  return read_csv(in, path.string());
}

} // namespace kanexpr
