#pragma once

#include <kanexpr/robots/read_urdf.hpp>
#include <kanexpr/robots/sdf/reader.hpp>

#include <string>

/// Reads robots from SDF files. Only this header and the folder `sdf` include libsdformat.
namespace kanexpr::robots {

/// Reads a robot from text in the Simulation Description Format (SDF).
inline read_robot read_sdf_text(const std::string& text, const reading_options& options = {}) {
  return detail::read_text<sdf::reader>(text, {}, options);
}

/// Reads a robot from an SDF file.
inline read_robot read_sdf(const std::string& path, const reading_options& options = {}) {
  return detail::read_file<sdf::reader>(path, options);
}

} // namespace kanexpr::robots
