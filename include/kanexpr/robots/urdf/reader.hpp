#pragma once

#include <kanexpr/robots/urdf/joint_reader.hpp>
#include <kanexpr/robots/urdf/link_reader.hpp>
#include <kanexpr/robots/urdf/options.hpp>

namespace kanexpr::robots::urdf {

/// Goes through the elements of a <robot>.
class reader {
public:
  reader(document& from, const urdf_options& options) : from_(from), options_(options) {}

  /// Whether there is one, and no mistake in it.
  bool read(const std::string& text) {
    const element* const root = from_.open(text);
    if (!root) return from_.fail(1, "there is no element, so this is no robot");
    if (std::string_view(root->Name()) != "robot")
      return from_.fail(*root, "the file begins with <" + shown(root->Name()) + ">, which is not <robot>");
    if (const char* name = root->Attribute("name")) robot.name = name;
    return is_expanded(*root) && read_links(*root) && read_joints(*root) && is_tree(*root);
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

  /// Whether every link but one is the child of one joint, and no way along parents comes back.
  bool is_tree(const element& root) {
    std::vector<int> leads_to(robot.links.size(), -1);
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      int& known = leads_to[static_cast<std::size_t>(robot.joints[j].child)];
      if (known >= 0)
        return from_.fail(joints_.line_of(static_cast<int>(j)),
                          "link " + name_of(robot.joints[j].child) + " is the child of two joints, " +
                              shown(robot.joints[static_cast<std::size_t>(known)].name) + " and " +
                              shown(robot.joints[j].name));
      known = static_cast<int>(j);
    }
    for (std::size_t l = 0; l < leads_to.size(); ++l) {
      if (leads_to[l] >= 0) continue;
      if (robot.root >= 0)
        return from_.fail(root, "no joint leads to link " + name_of(robot.root) + " nor to link " +
                                    name_of(static_cast<int>(l)) + "; a robot has one such link, its root");
      robot.root = static_cast<int>(l);
    }
    if (robot.root < 0)
      return from_.fail(root, "the joints go round in a circle: a joint leads to every link");
    return reaches_all(leads_to);
  }

  bool reaches_all(const std::vector<int>& leads_to) {
    std::vector<bool> reached(leads_to.size(), false);
    reached[static_cast<std::size_t>(robot.root)] = true;
    std::vector<std::size_t> way;
    for (std::size_t l = 0; l < leads_to.size(); ++l) {
      way.clear();
      std::size_t at = l;
      for (; !reached[at];
           at = static_cast<std::size_t>(robot.joints[static_cast<std::size_t>(leads_to[at])].parent)) {
        if (way.size() > leads_to.size())
          return from_.fail(joints_.line_of(leads_to[l]), "the joints go round in a circle: link " +
                                                              name_of(static_cast<int>(l)) +
                                                              " hangs on itself");
        way.push_back(at);
      }
      for (std::size_t each : way) reached[each] = true;
    }
    return true;
  }

  std::string name_of(int link) const { return shown(robot.links[static_cast<std::size_t>(link)].name); }

  document& from_;
  urdf_options options_;
  places links_{};
  joint_reader joints_{from_, links_, robot};
};

} // namespace kanexpr::robots::urdf
