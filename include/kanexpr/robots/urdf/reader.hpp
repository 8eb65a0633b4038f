#pragma once

#include <kanexpr/robots/articulation.hpp>
#include <kanexpr/robots/check_robot.hpp>
#include <kanexpr/robots/reading_options.hpp>
#include <kanexpr/robots/urdf/gazebo_words.hpp>
#include <kanexpr/robots/urdf/joint_reader.hpp>
#include <kanexpr/robots/urdf/link_reader.hpp>

#include <string>
#include <string_view>
#include <utility>

namespace kanexpr::robots::urdf {

/// Reads the elements of a <robot>.
class reader {
public:
  reader(document& from, const reading_options& options) : from_(from), options_(options) {}

  /// Reads the text; returns true if it contains a robot without a mistake.
  bool read(const std::string& text) {
    const element* const root = from_.open(text);
    if (!root) return from_.fail(1, "there is no element, so the file does not describe a robot");
    if (std::string_view(root->Name()) != "robot")
      return from_.fail(*root, "the root element is <" + shown(root->Name()) + ">, expected <robot>");
    if (const char* name = root->Attribute("name")) robot.name = name;
    if (!is_expanded(*root)) return false;
    from_.know_elements(*root,
                        {"link", "joint", "transmission", "gazebo", "material", "sensor", "ros2_control"},
                        "the robot");
    if (!read_links(*root)) return false;
    for (const element* e = root->FirstChildElement("gazebo"); e; e = e->NextSiblingElement("gazebo"))
      read_gazebo(from_, *e, robot);
    return read_joints(*root) && is_tree(*root) && (settle_gravity(robot), true);
  }

  robots::robot robot{};

private:
  bool is_expanded(const element& root) {
    for (const element* e = root.FirstChildElement(); e; e = e->NextSiblingElement())
      if (std::string_view(e->Name()).starts_with("xacro:"))
        return from_.fail(*e, "this is a xacro file; run xacro on it first");
    return true;
  }

  bool read_links(const element& root) {
    for (const element* e = root.FirstChildElement("link"); e; e = e->NextSiblingElement("link")) {
      link read;
      if (!read_link(from_, *e, read)) return false;
      if (!links_.emplace(read.name, static_cast<int>(robot.links.size())).second)
        return from_.fail(*e, "two links are called " + shown(read.name));
      robot.links.push_back(std::move(read));
    }
    return !links_.empty() || from_.fail(root, "the robot has no links");
  }

  bool read_joints(const element& root) {
    for (const element* e = root.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint"))
      if (!joints_.read(*e)) return false;
    if (options_.mimic && !joints_.read_mimics()) return false;
    for (const element* e = root.FirstChildElement("transmission"); e;
         e = e->NextSiblingElement("transmission"))
      if (!joints_.read_transmission(*e)) return false;
    return true;
  }

  bool is_tree(const element& root) {
    const found_root found = root_of(robot);
    robot.root = found.link;
    const auto& [what, joint] = found.mistake;
    return what.empty() || from_.fail(joint < 0 ? root.GetLineNum() : joints_.line_of(joint), what);
  }

  document& from_;
  reading_options options_;
  places links_{};
  joint_reader joints_{from_, links_, robot};
};

} // namespace kanexpr::robots::urdf
