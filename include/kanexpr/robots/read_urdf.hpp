#pragma once

#include <kanexpr/base/file_text.hpp>
#include <kanexpr/base/outcome.hpp>
#include <kanexpr/robots/options.hpp>
#include <kanexpr/robots/robot.hpp>
#include <kanexpr/robots/urdf/document.hpp>
#include <kanexpr/robots/urdf/reader.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::robots {

/// A robot, or the reason why it could not be read: "line 12 of arm.urdf: the mass of link elbow is
/// negative".
struct [[nodiscard]] read_robot : outcome {
  using outcome::outcome;

  robots::robot robot{};
  /// Sentences about ignored or unusual contents: "line 80 of arm.urdf: the inertia of link hand is not
  /// physical: …".
  std::vector<std::string> notes{};
};

namespace detail {

/// Reads a robot from text with the reader for one format.
template <class Reader>
read_robot read_text(const std::string& text, const std::string& called, const reading_options& options) {
  urdf::document from(called, options.right_angles);
  Reader reader(from, options);
  read_robot read = reader.read(text) ? read_robot() : read_robot(from.mistake());
  if (read) read.robot = std::move(reader.robot);
  read.notes = from.take_notes();
  return read;
}

template <class Reader>
read_robot read_file(const std::string& path, const reading_options& options) {
  const std::optional<std::string> text = base::text_of(path);
  if (!text) return read_robot(path + " cannot be read");
  return read_text<Reader>(*text, path.substr(path.rfind('/') + 1), options);
}

} // namespace detail

/// Reads a robot from text in the Unified Robot Description Format (URDF).
inline read_robot read_urdf_text(const std::string& text, const reading_options& options = {}) {
  return detail::read_text<urdf::reader>(text, {}, options);
}

/// Reads a robot from a URDF file.
inline read_robot read_urdf(const std::string& path, const reading_options& options = {}) {
  return detail::read_file<urdf::reader>(path, options);
}

} // namespace kanexpr::robots
