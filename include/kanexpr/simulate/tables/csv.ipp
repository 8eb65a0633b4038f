#pragma once

#include <kanexpr/simulate/tables/csv_reader.hpp>
#include <kanexpr/simulate/tables/csv_writer.hpp>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace kanexpr {

namespace simulated {

/// Returns, for example, "run.csv cannot be opened: No such file or directory".
inline outcome not_opened(const std::string& path) {
  return outcome(path + " cannot be opened: " + std::generic_category().message(errno));
}

} // namespace simulated

KANEXPR_SIMULATIONS outcome write_csv(const table& all, const file_path& path) {
  if (!all) return outcome(all.cause()); // before it replaces a file
  std::ofstream out(path.text(), std::ios::binary);
  if (!out) return simulated::not_opened(path.text());
  return write_csv(all, out, path.text());
}

KANEXPR_SIMULATIONS table read_csv(const file_path& path) {
  std::ifstream in(path.text(), std::ios::binary);
  if (!in) return table(simulated::not_opened(path.text()));
  return read_csv(in, path.text());
}

} // namespace kanexpr
