#pragma once

#include <kanexpr/base/mesh_kind.hpp>
#include <kanexpr/robots/header_writer.hpp>
#include <kanexpr/robots/mesh_finder.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace kanexpr::robots {

/// Writes the picture of a robot as a second header next to that of its model: the boxes, cylinders, spheres
/// and meshes of its links. A link whose only shapes are meshes that were not found is drawn as rods from its
/// origin to its joints.
class picture_writer {
public:
  /// `folder` contains the robot file; meshes are searched relative to it. If it is empty, no meshes are
  /// found.
  picture_writer(const robot& r, const model_options& options, const std::string& folder = {})
      : robot_(r), options_(options), plan_(plan_of(r, options)), files_(folder) {}

  /// Returns the header of a picture in the namespace `called`; the model is in `called`.hpp. Empty if the
  /// robot has no model.
  std::string write(const std::string& called) {
    if (!plan_.mistake.empty()) return {};
    for (std::size_t l = 0; l < robot_.links.size(); ++l) draw(l);
    if (words_.empty()) draw_joints();
    const std::string include = std::string("#") + "include "; // in the header, not in this file
    std::string told =
        "#pragma once\n\n" + include + "<" + called + ".hpp>\n\n" + include +
        "<kanexpr/animate/animated.hpp>\n\n" +
        header_text::opened(called, {"box", "colour", "cylinder", "direction_cosines", "files_in", "ground",
                                     "mesh", "offset", "rod", "seen_from", "show", "sphere", "up"}) +
        out_ + "\n/// The picture of the robot" + (shown_meshes_ == 0 ? "" : ", with meshes from files") +
        ".\n";
    std::vector<std::string> all{"System", "up<N::z>", "seen_from<N::x - 1.2 * N::y + 0.6 * N::z>"};
    if (options_.base == base_kind::fixed) all.push_back("ground<>");
    if (shown_meshes_ != 0) all.push_back("files_in<" + literal(files_.folder()) + ">");
    all.insert(all.end(), words_.begin(), words_.end());
    return told + header_text::wrapped("using picture = kanexpr::picture<", all) + ">;\n\n} // namespace " +
           called + "\n";
  }

  /// A sentence that names the meshes that are not drawn; empty if all are drawn.
  std::string note() const {
    if (left_out_.empty()) return {};
    const bool is_one = left_out_.size() == 1;
    return std::to_string(left_out_.size()) + (is_one ? " mesh is" : " meshes are") +
           " omitted from the picture: " + left_out_[0] + (is_one ? "" : ", among others");
  }

private:
  const std::string& name(std::size_t link) const { return plan_.links[link]; }

  void show(const std::string& shape, const char* colour) {
    words_.push_back("show<" + shape + ", colour<\"" + colour + "\">>");
  }

  void draw(std::size_t link) {
    int count = 0;
    bool lacks = false;
    for (shape s : robot_.links[link].visual) {
      if (s.is == shape_kind::mesh && !find(s, link)) {
        lacks = true;
        continue;
      }
      if (is_solid(s)) draw(link, s, ++count);
    }
    if (count == 0 && lacks) draw_rods(link);
  }

  /// Finds the file of a mesh and sets its path as the picture uses it; returns false if the file is missing
  /// or of an unsupported kind.
  bool find(shape& s, std::size_t link) {
    const std::optional<std::string> found = files_.find(s.file);
    const bool is_known = found && !mesh_kind_of(*found).empty();
    if (is_known) {
      s.file = *found;
      return true;
    }
    constexpr std::size_t most = 76; // keeps the end, which is the most informative part
    const std::string file = s.file.size() > most ? "..." + s.file.substr(s.file.size() - most) : s.file;
    const std::string what = "the mesh " + header_text::comment(file) + " of link " +
                             header_text::comment(robot_.links[link].name) +
                             (found ? " has a format that pages cannot show" : " was not found");
    out_ += "// " + what + "\n";
    left_out_.push_back(what);
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
    const std::string x = header_text::digits(s[0]), y = header_text::digits(s[1]),
                      z = header_text::digits(s[2]);
    if (x == y && y == z) return x == "1" ? "" : ", " + x;
    return ", " + x + ", " + y + ", " + z;
  }

  static bool is_solid(const shape& s) {
    if (s.is == shape_kind::mesh)
      return std::abs(s.size[0]) > 0 && std::abs(s.size[1]) > 0 && std::abs(s.size[2]) > 0;
    const bool second = s.is == shape_kind::sphere || s.size[1] > 0;
    return s.size[0] > 0 && second && (s.is != shape_kind::box || s.size[2] > 0);
  }

  void draw(std::size_t link, const shape& s, int which) {
    const std::string own = name(link) + "_shape" + (which == 1 ? "" : std::to_string(which));
    std::string axes = name(link), point = name(link);
    if (!is_zero(s.placed.at)) {
      out_ += "struct " + own + " : offset<" + own + ", " + point + ", " +
              header_text::along(axes, s.placed.at) + "> {};\n";
      point = own;
    }
    const auto sizes = [&](int n) {
      std::string listed;
      for (int i = 0; i < n; ++i) listed += ", " + header_text::digits(s.size[static_cast<std::size_t>(i)]);
      return listed;
    };
    if ((s.is == shape_kind::box || s.is == shape_kind::mesh) && s.placed.turn != no_rotation) {
      std::string cosines;
      for (const vector3& row : s.placed.turn)
        for (double e : row) cosines += ", " + header_text::digits(e);
      out_ += "struct " + own + "_axes : direction_cosines<" + own + "_axes, " + axes + cosines + "> {};\n";
      axes = own + "_axes";
    }
    switch (s.is) {
    case shape_kind::box: return show("box<" + axes + ", " + point + sizes(3) + ">", link_colour);
    case shape_kind::cylinder:
    case shape_kind::capsule:
      return show("cylinder<" + axes + ", " + point + ", " +
                      header_text::along(axes, turned(s.placed.turn, {0, 0, 1})) + sizes(2) + ">",
                  link_colour);
    case shape_kind::sphere: return show("sphere<" + point + sizes(1) + ">", link_colour);
    case shape_kind::mesh: return show_mesh("mesh<" + axes + ", " + point, s);
    }
  }

  /// Shows a mesh. A COLLADA file defines its own colours.
  void show_mesh(const std::string& begun, const shape& s) {
    const std::string drawn = begun + ", " + literal(s.file) + scale_of(s.size) + ">";
    ++shown_meshes_;
    if (mesh_kind_of(s.file) == "dae")
      words_.push_back("show<" + drawn + ">");
    else
      show(drawn, link_colour);
  }

  /// The thickness of rods: a twentieth of the longest distance between two joints.
  std::string thickness() const {
    double longest = 0;
    for (const joint& j : robot_.joints)
      longest = (std::max)(longest, std::sqrt(dot(j.origin.at, j.origin.at)));
    return header_text::digits(longest > 0 ? (std::max)((std::round)(longest * 50), 1.0) / 1000 : 0.05);
  }

  void draw_rods(std::size_t link) {
    for (const joint& j : robot_.joints)
      if (static_cast<std::size_t>(j.parent) == link && !is_zero(j.origin.at))
        show("rod<" + name(link) + ", " + name(static_cast<std::size_t>(j.child)) + ", " + thickness() + ">",
             link_colour);
  }

  /// Draws the joints of a robot without visible shapes.
  void draw_joints() {
    for (const moving_body& b : plan_.what.bodies)
      show("sphere<" + name(static_cast<std::size_t>(b.link)) + ", " + thickness() + ">", joint_colour);
  }

  static constexpr const char* link_colour = "#c4c8cb";
  static constexpr const char* joint_colour = "#d98a2b";

  const robot& robot_;
  model_options options_;
  robots::plan plan_;
  mesh_finder files_;
  std::vector<std::string> words_{};
  std::string out_{};
  std::vector<std::string> left_out_{}; ///< meshes
  int shown_meshes_ = 0;
};

} // namespace kanexpr::robots
