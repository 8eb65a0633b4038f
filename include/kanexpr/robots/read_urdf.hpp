#pragma once

#include <kanexpr/robots/read_file.hpp>
#include <kanexpr/robots/urdf/reader.hpp>

#include <string>

namespace kanexpr::robots {

/// Reads a robot from a text in the Unified Robot Description Format (URDF).
inline read_robot read_urdf_text(const std::string& text, const reading_options& options = {}) {
  return detail::read_text<urdf::reader>(text, {}, options);
}

/// Reads a robot from a URDF file.
inline read_robot read_urdf(const std::string& path, const reading_options& options = {}) {
  return detail::read_file<urdf::reader>(path, options);
}

} // namespace kanexpr::robots
