#pragma once

#include <kanexpr/base/mesh_kind.hpp>
#include <kanexpr/robots/header_writer.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace kanexpr::robots {

/// Finds the files that a robot description refers to. A ROS package is a folder next to or above the
/// description, or any folder that contains the description, whatever its name.
class mesh_finder {
public:
  /// `folder` contains the description; if `folder` is empty, no files are found.
  explicit mesh_finder(const std::string& folder) {
    std::error_code failed;
    if (!folder.empty()) folder_ = std::filesystem::weakly_canonical(folder, failed);
  }

  /// The absolute path of the folder of the description.
  std::string folder() const { return folder_.generic_string(); }

  /// The path of a file relative to the folder of the description, or the absolute path if the description
  /// specifies one.
  std::optional<std::string> find(std::string_view named) const {
    if (folder_.empty() || named.empty()) return {};
    for (std::string_view scheme : {"package://", "model://"})
      if (named.starts_with(scheme)) return find_in_package(named.substr(scheme.size()));
    if (named.starts_with("file://")) named.remove_prefix(std::string_view("file://").size());
    if (!is_file(folder_ / named)) return {};
    return std::filesystem::path(named).generic_string();
  }

private:
  std::optional<std::string> find_in_package(std::string_view named) const {
    named.remove_prefix((std::min)(named.find_first_not_of('/'), named.size()));
    const std::size_t slash = named.find('/');
    if (slash == named.npos) return {};
    for (std::string_view below : {named, named.substr(slash + 1)})
      for (std::filesystem::path in = folder_;; in = in.parent_path()) {
        if (is_file(in / below))
          return (in / below).lexically_normal().lexically_relative(folder_).generic_string();
        if (in == in.parent_path()) break;
      }
    return {};
  }

  static bool is_file(const std::filesystem::path& path) {
    std::error_code failed;
    return std::filesystem::is_regular_file(path, failed);
  }

  std::filesystem::path folder_{};
};

/// Writes the picture of a robot as a second header next to that of its model: the boxes, cylinders, spheres
/// and meshes of its links. A link whose only shapes are meshes that were not found is drawn as rods from its
/// origin to its joints.
class picture_writer {
public:
  /// `folder` contains the robot file; meshes are searched relative to it. If it is empty, no meshes are
  /// found.
  picture_writer(const robot& r, const model_options& options, const std::string& folder = {})
      : robot_(r), plan_(plan_of(r, options)), files_(folder) {}

  /// Returns the header of a picture in the namespace `called`; the model is in `called`.hpp. Empty if the
  /// robot has no model.
  std::string write(const std::string& called) {
    if (!plan_.mistake.empty()) return {};
    for (std::size_t l = 0; l < robot_.links.size(); ++l) draw(l);
    if (elements_.empty()) draw_joints();
    constexpr const char* words = "box colour cylinder direction_cosines files_in ground mesh offset rod "
                                  "seen_from show sphere up";
    const std::string begin = "#pragma once\n\n" + cpp::include(called + ".hpp") + "\n" +
                              cpp::include("kanexpr/animate/animated.hpp") + "\n" +
                              cpp::namespace_opening(called, words) + declarations_ +
                              "\n/// The picture of the robot" +
                              (shown_meshes_ == 0 ? "" : ", with meshes from files") + ".\n";
    std::vector<std::string> all{"System", "up<N::z>", "seen_from<N::x - 1.2 * N::y + 0.6 * N::z>"};
    if (!plan_.has_floating_base()) all.push_back("ground<>");
    if (shown_meshes_ != 0) all.push_back("files_in<" + literal(files_.folder()) + ">");
    all.insert(all.end(), elements_.begin(), elements_.end());
    return begin + cpp::wrapped("using picture = kanexpr::picture<", all) + ">;\n\n} // namespace " + called +
           "\n";
  }

  /// A message that names the meshes that are not drawn; empty if all are drawn.
  std::string note() const {
    if (omitted_meshes_.empty()) return {};
    const bool is_single = omitted_meshes_.size() == 1;
    return std::to_string(omitted_meshes_.size()) + (is_single ? " mesh is" : " meshes are") +
           " omitted from the picture: " + omitted_meshes_[0] + (is_single ? "" : ", among others");
  }

private:
  void show(const std::string& shape, const char* colour) {
    elements_.push_back("show<" + shape + ", colour<\"" + colour + "\">>");
  }

  void draw(std::size_t link) {
    const std::size_t omitted = omitted_meshes_.size();
    int count = 0;
    for (shape s : robot_.links[link].visual)
      if ((s.kind != shape_kind::mesh || find(s, link)) && is_solid(s)) draw(link, s, ++count);
    if (count == 0 && omitted_meshes_.size() != omitted) draw_rods(link);
  }

  /// Finds the file of a mesh and stores the path that the picture uses; returns false if the file is missing
  /// or of an unsupported kind.
  bool find(shape& s, std::size_t link) {
    const std::optional<std::string> found = files_.find(s.file);
    if (found && !mesh_kind_of(*found).empty()) {
      s.file = *found;
      return true;
    }
    constexpr std::size_t most = 76; // keeps the end, which is the most informative part
    const std::string file = s.file.size() > most ? "..." + s.file.substr(s.file.size() - most) : s.file;
    const std::string what = "the mesh " + cpp::comment(file) + " of link " +
                             cpp::comment(robot_.links[link].name) +
                             (found ? " has a format that pages cannot show" : " was not found");
    declarations_ += "// " + what + "\n";
    omitted_meshes_.push_back(what);
    return false;
  }

  /// Returns a name as a string literal for a header whose lines may be broken after commas and signs.
  static std::string literal(const std::string& name) {
    std::string quoted = "\"";
    char before = 0;
    for (char c : name) {
      const auto value = static_cast<unsigned char>(c);
      const bool may_break = c == ' ' && (before == ',' || before == '+' || before == '-');
      if (c == '"' || c == '\\' || value < ' ' || value == 0x7f || may_break) {
        quoted += '\\';
        for (int shift : {6, 3, 0}) quoted += static_cast<char>('0' + (value >> shift & 7));
      } else {
        quoted += c;
      }
      before = c;
    }
    return quoted + "\"";
  }

  static std::string scale_of(const vector3& s) {
    const std::string x = cpp::number(s[0]), y = cpp::number(s[1]), z = cpp::number(s[2]);
    if (x == y && y == z) return x == "1" ? "" : ", " + x;
    return ", " + x + ", " + y + ", " + z;
  }

  static bool is_solid(const shape& s) {
    if (s.kind == shape_kind::mesh)
      return std::abs(s.size[0]) > 0 && std::abs(s.size[1]) > 0 && std::abs(s.size[2]) > 0;
    const bool second = s.kind == shape_kind::sphere || s.size[1] > 0;
    return s.size[0] > 0 && second && (s.kind != shape_kind::box || s.size[2] > 0);
  }

  void draw(std::size_t link, const shape& s, int which) {
    const std::string own = plan_.links[link] + "_shape" + (which == 1 ? "" : std::to_string(which));
    std::string axes = plan_.links[link], point = axes;
    const auto declare = [&](const std::string& called, const std::string& word, const std::string& rest) {
      declarations_ += "struct " + called + " : " + word + "<" + called + ", " + rest + "> {};\n";
      return called;
    };
    if (!is_zero(s.origin.position))
      point = declare(own, "offset", point + ", " + cpp::along(axes, s.origin.position));
    const bool has_axes = s.kind == shape_kind::box || s.kind == shape_kind::mesh;
    if (has_axes && s.origin.orientation != no_rotation)
      axes = declare(own + "_axes", "direction_cosines", axes + ", " + cpp::list(s.origin.orientation));
    switch (s.kind) {
    case shape_kind::box: return show("box<" + axes + ", " + point + sizes(s, 3) + ">", link_colour);
    case shape_kind::cylinder:
    case shape_kind::capsule:
      return show("cylinder<" + axes + ", " + point + ", " +
                      cpp::along(axes, rotated(s.origin.orientation, {0, 0, 1})) + sizes(s, 2) + ">",
                  link_colour);
    case shape_kind::sphere: return show("sphere<" + point + sizes(s, 1) + ">", link_colour);
    case shape_kind::mesh: return show_mesh("mesh<" + axes + ", " + point, s);
    }
  }

  static std::string sizes(const shape& s, std::size_t count) {
    std::string listed;
    for (std::size_t i = 0; i < count; ++i) listed += ", " + cpp::number(s.size[i]);
    return listed;
  }

  /// Shows a mesh. A COLLADA file defines its own colours.
  void show_mesh(const std::string& begun, const shape& s) {
    const std::string drawn = begun + ", " + literal(s.file) + scale_of(s.size) + ">";
    ++shown_meshes_;
    if (mesh_kind_of(s.file) == "dae")
      elements_.push_back("show<" + drawn + ">");
    else
      show(drawn, link_colour);
  }

  /// The thickness of rods: a twentieth of the longest distance between two joints.
  std::string thickness() const {
    double longest = 0;
    for (const joint& j : robot_.joints)
      longest = (std::max)(longest, std::sqrt(dot(j.origin.position, j.origin.position)));
    return cpp::number(longest > 0 ? (std::max)((std::round)(longest * 50), 1.0) / 1000 : 0.05);
  }

  void draw_rods(std::size_t link) {
    for (const joint& j : robot_.joints)
      if (static_cast<std::size_t>(j.parent) == link && !is_zero(j.origin.position))
        show("rod<" + plan_.links[link] + ", " + plan_.name(j.child) + ", " + thickness() + ">", link_colour);
  }

  /// Draws the joints of a robot without visible shapes.
  void draw_joints() {
    for (const moving_body& b : plan_.tree.bodies)
      show("sphere<" + plan_.name(b.link) + ", " + thickness() + ">", joint_colour);
  }

  static constexpr const char* link_colour = "#c4c8cb";
  static constexpr const char* joint_colour = "#d98a2b";

  const robot& robot_;
  robots::plan plan_;
  mesh_finder files_;
  std::vector<std::string> elements_{};
  std::string declarations_{};
  std::vector<std::string> omitted_meshes_{}; ///< sentences
  int shown_meshes_ = 0;
};

} // namespace kanexpr::robots
