#pragma once

#include <kanexpr/robots/read_file.hpp>
#include <kanexpr/robots/urdf/reader.hpp>

namespace kanexpr::robots {

/// The robot of a text in the Unified Robot Description Format.
inline read_robot read_urdf_text(const std::string& text, const reading_options& options = {}) {
  return detail::read_text<urdf::reader>(text, {}, options);
}

/// The same of a file.
inline read_robot read_urdf(const std::string& path, const reading_options& options = {}) {
  return detail::read_file<urdf::reader>(path, options);
}

} // namespace kanexpr::robots
