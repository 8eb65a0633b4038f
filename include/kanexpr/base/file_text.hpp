#pragma once

#include <kanexpr/base/file_path.hpp>

#include <fstream>
#include <ios>
#include <optional>
#include <string>

namespace kanexpr::base {

/// The text of a file; nothing if it cannot be read, for example because it is a folder.
inline std::optional<std::string> text_of(const file_path& path) {
  std::ifstream file(path.text(), std::ios::binary);
  if (!file.is_open()) return {};
  std::string text;
  char piece[4096];
  // Unlike iterators over the file, this function throws nothing.
  while (file.read(piece, sizeof piece) || file.gcount() > 0)
    text.append(piece, static_cast<std::string::size_type>(file.gcount()));
  if (file.bad()) return {};
  return text;
}

} // namespace kanexpr::base
