#pragma once

#include <kanexpr/robots/read_file.hpp>
#include <kanexpr/robots/sdf/reader.hpp>

/// Robots from files of the Simulation Description Format, by libsdformat, which no other header includes.
namespace kanexpr::robots {

/// The robot of a text in the Simulation Description Format.
inline read_robot read_sdf_text(const std::string& text, const reading_options& options = {}) {
  return detail::read_text<sdf_files::reader>(text, {}, options);
}

/// The same of a file.
inline read_robot read_sdf(const std::string& path, const reading_options& options = {}) {
  return detail::read_file<sdf_files::reader>(path, options);
}

} // namespace kanexpr::robots
