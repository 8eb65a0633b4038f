#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace docs {

/// The contents of a text block in the documentation.
inline std::string text(const std::string& name) {
  const std::ifstream file(KANEXPR_SNIPPETS "/" + name);
  if (!file) throw std::runtime_error("no block " + name);
  std::ostringstream all;
  all << file.rdbuf();
  return all.str();
}

} // namespace docs
