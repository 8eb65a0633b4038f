#pragma once

#include <string_view>

namespace kanexpr {

/// @internal The kind of a mesh file, given by its extension: "stl" for "Base.STL". Supports STL, COLLADA
/// (dae) and Wavefront OBJ; empty for all other files.
constexpr std::string_view mesh_kind_of(std::string_view file) {
  const auto ends_with = [file](std::string_view kind) {
    const std::size_t from = file.size() - kind.size();
    if (file.size() <= kind.size() || file[from - 1] != '.') return false;
    for (std::size_t i = 0; i < kind.size(); ++i) {
      const char c = file[from + i];
      if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != kind[i]) return false;
    }
    return true;
  };
  for (std::string_view kind : {"stl", "dae", "obj"})
    if (ends_with(kind)) return kind;
  return {};
}

} // namespace kanexpr
