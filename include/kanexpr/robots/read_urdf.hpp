#pragma once

#include <kanexpr/robots/read_robot.hpp>
#include <kanexpr/robots/urdf/reader.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>

namespace kanexpr::robots {

namespace detail {

inline read_robot read_urdf(const std::string& text, const std::string& called, const urdf_options& options) {
  urdf::document from(called, options.right_angles);
  urdf::reader reader(from, options);
  read_robot read = reader.read(text) ? read_robot() : read_robot(from.mistake());
  if (read) read.robot = std::move(reader.robot);
  read.notes = from.take_notes();
  return read;
}

} // namespace detail

/// The robot of a text in the Unified Robot Description Format.
inline read_robot read_urdf_text(const std::string& text, const urdf_options& options = {}) {
  return detail::read_urdf(text, {}, options);
}

/// The same of a file.
inline read_robot read_urdf(const std::string& path, const urdf_options& options = {}) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) return read_robot(path + " cannot be read");
  return detail::read_urdf(text, path.substr(path.rfind('/') + 1), options);
}

} // namespace kanexpr::robots
