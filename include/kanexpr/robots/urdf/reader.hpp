#pragma once

#include <kanexpr/robots/articulation.hpp>
#include <kanexpr/robots/check_robot.hpp>
#include <kanexpr/robots/options.hpp>
#include <kanexpr/robots/robot.hpp>
#include <kanexpr/robots/urdf/document.hpp>
#include <kanexpr/robots/urdf/joint_reader.hpp>
#include <kanexpr/robots/urdf/link_reader.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace kanexpr::robots::urdf {

/// Reads the Gazebo elements that switch off gravity for a link. Other elements that would change the motion
/// of the robot are noted and ignored.
inline void read_gazebo_elements(document& from, const element& e, robot& into) {
  const char* const reference = e.Attribute("reference");
  const auto of_link = std::ranges::find_if(
      into.links, [&](const link& l) { return reference != nullptr && l.name == reference; });
  constexpr std::pair<std::string_view, bool> words[]{{"gravity", false},        {"turnGravityOff", true},
                                                      {"kinematic", true},       {"static", true},
                                                      {"springStiffness", true}, {"dampingFactor", true}};
  for (const element* each : children(e)) {
    const std::string_view is = each->Name();
    std::string_view text = each->GetText() ? each->GetText() : "";
    const std::string_view value = next_word(text);
    const bool is_no = value == "false" || number_in(value) == 0;
    for (const auto& [word, matters] : words) {
      if (is != word || value.empty() || is_no == matters) continue;
      if ((is == "gravity" || is == "turnGravityOff") && of_link != into.links.end())
        of_link->weightless = true;
      else
        from.note(*each, "<" + printable(is) + ">" + printable(value) + "</" + printable(is) + ">" +
                             (reference != nullptr ? " of " + printable(reference) : "") +
                             ", a Gazebo element, is ignored");
    }
  }
}

/// Reads the elements of a <robot>.
class reader {
public:
  reader(document& from, const reading_options& options) : from_(from), options_(options) {}

  /// Reads the text; returns true if it describes a robot without errors.
  bool read(const std::string& text) {
    const element* const root = from_.open(text);
    if (!root) return from_.fail(1, "there is no element, so the file does not describe a robot");
    if (std::string_view(root->Name()) != "robot")
      return from_.fail(*root, "the root element is <" + printable(root->Name()) + ">, expected <robot>");
    if (const char* name = root->Attribute("name")) robot.name = name;
    if (!is_expanded(*root)) return false;
    from_.note_unknown_elements(
        *root, {"link", "joint", "transmission", "gazebo", "material", "sensor", "ros2_control"},
        "the robot");
    if (!read_links(*root)) return false;
    for (const element* e : children(*root, "gazebo")) read_gazebo_elements(from_, *e, robot);
    return read_joints(*root) && is_tree(*root) && (simplify_gravity(robot), true);
  }

  robots::robot robot{};

private:
  bool is_expanded(const element& root) {
    for (const element* e : children(root))
      if (std::string_view(e->Name()).starts_with("xacro:"))
        return from_.fail(*e, "this is a xacro file; run xacro on it first");
    return true;
  }

  bool read_links(const element& root) {
    for (const element* e : children(root, "link")) {
      link read;
      if (!read_link(from_, *e, read)) return false;
      if (!links_.emplace(read.name, static_cast<int>(robot.links.size())).second)
        return from_.fail(*e, "two links are called " + printable(read.name));
      robot.links.push_back(std::move(read));
    }
    return !links_.empty() || from_.fail(root, "the robot has no links");
  }

  bool read_joints(const element& root) {
    for (const element* e : children(root, "joint"))
      if (!joints_.read(*e)) return false;
    if (options_.mimic && !joints_.read_mimics()) return false;
    for (const element* e : children(root, "transmission"))
      if (!joints_.read_transmission(*e)) return false;
    return true;
  }

  bool is_tree(const element& root) {
    const found_root found = root_of(robot);
    robot.root = found.link;
    return found.mistake.empty() ||
           from_.fail(found.joint < 0 ? root.GetLineNum() : joints_.line_of(found.joint), found.mistake);
  }

  document& from_;
  reading_options options_;
  index_by_name links_{};
  joint_reader joints_{from_, links_, robot};
};

} // namespace kanexpr::robots::urdf
