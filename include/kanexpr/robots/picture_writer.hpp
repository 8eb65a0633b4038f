#pragma once

#include <kanexpr/robots/header_writer.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace kanexpr::robots {

/// What a robot looks like, as a header beside that of its model: the boxes, cylinders and spheres of its
/// links. A link that has meshes alone is drawn as rods from its origin to the joints on it, since what is in
/// a mesh is not read.
class picture_writer {
public:
  picture_writer(const robot& r, const model_options& options)
      : robot_(r), options_(options), plan_(plan_of(r, options)) {}

  /// The header of a picture in the namespace `called`, whose model is in `called`.hpp. Of a robot without a
  /// model: nothing.
  std::string write(const std::string& called) {
    if (!plan_.mistake.empty()) return {};
    for (std::size_t l = 0; l < robot_.links.size(); ++l) draw(l);
    if (words_.empty()) draw_joints();
    const std::string include = std::string("#") + "include "; // of the header, not of this file
    std::string told = "#pragma once\n\n" + include + "<" + called + ".hpp>\n\n" + include +
                       "<kanexpr/animate/animated.hpp>\n\n" + "namespace " + called + " {\n\n" + out_ +
                       "\n/// What is seen of the robot.\n";
    std::vector<std::string> all{"System", "up<N::z>", "seen_from<N::x - 1.2 * N::y + 0.6 * N::z>"};
    if (options_.base == base_kind::fixed) all.push_back("ground<>");
    all.insert(all.end(), words_.begin(), words_.end());
    return told + text::wrapped("using picture = kanexpr::picture<", all) + ">;\n\n} // namespace " + called +
           "\n";
  }

private:
  const std::string& name(std::size_t link) const { return plan_.links[link]; }

  void show(const std::string& shape, const char* colour) {
    words_.push_back("show<" + shape + ", colour<\"" + colour + "\">>");
  }

  void draw(std::size_t link) {
    int count = 0;
    bool has_mesh = false;
    for (const shape& s : robot_.links[link].visual) {
      has_mesh = has_mesh || s.is == shape_kind::mesh;
      if (s.is != shape_kind::mesh && is_solid(s)) draw(link, s, ++count);
    }
    if (count == 0 && has_mesh) draw_rods(link);
  }

  static bool is_solid(const shape& s) {
    const bool second = s.is == shape_kind::sphere || s.size[1] > 0;
    return s.size[0] > 0 && second && (s.is != shape_kind::box || s.size[2] > 0);
  }

  void draw(std::size_t link, const shape& s, int which) {
    const std::string own = name(link) + "_shape" + (which == 1 ? "" : std::to_string(which));
    std::string axes = name(link), point = name(link);
    if (!is_zero(s.placed.at)) {
      out_ += "struct " + own + " : offset<" + own + ", " + point + ", " + text::along(axes, s.placed.at) +
              "> {};\n";
      point = own;
    }
    const auto sizes = [&](int n) {
      std::string listed;
      for (int i = 0; i < n; ++i) listed += ", " + text::digits(s.size[static_cast<std::size_t>(i)]);
      return listed;
    };
    switch (s.is) {
    case shape_kind::box:
      if (s.placed.turn != no_rotation) {
        std::string cosines;
        for (const vector3& row : s.placed.turn)
          for (double e : row) cosines += ", " + text::digits(e);
        out_ += "struct " + own + "_axes : direction_cosines<" + own + "_axes, " + axes + cosines + "> {};\n";
        axes = own + "_axes";
      }
      return show("box<" + axes + ", " + point + sizes(3) + ">", link_colour);
    case shape_kind::cylinder:
    case shape_kind::capsule:
      return show("cylinder<" + axes + ", " + point + ", " +
                      text::along(axes, turned(s.placed.turn, {0, 0, 1})) + sizes(2) + ">",
                  link_colour);
    case shape_kind::sphere: return show("sphere<" + point + sizes(1) + ">", link_colour);
    case shape_kind::mesh: return;
    }
  }

  /// As thick as a twentieth of the longest way between two joints.
  std::string thickness() const {
    double longest = 0;
    for (const joint& j : robot_.joints)
      longest = (std::max)(longest, std::sqrt(dot(j.origin.at, j.origin.at)));
    return text::digits(longest > 0 ? (std::max)((std::round)(longest * 50), 1.0) / 1000 : 0.05);
  }

  void draw_rods(std::size_t link) {
    for (const joint& j : robot_.joints)
      if (static_cast<std::size_t>(j.parent) == link && !is_zero(j.origin.at))
        show("rod<" + name(link) + ", " + name(static_cast<std::size_t>(j.child)) + ", " + thickness() + ">",
             link_colour);
  }

  /// Of a robot of which nothing is seen.
  void draw_joints() {
    for (const moving_body& b : plan_.what.bodies)
      show("sphere<" + name(static_cast<std::size_t>(b.link)) + ", " + thickness() + ">", joint_colour);
  }

  static constexpr const char* link_colour = "#c4c8cb";
  static constexpr const char* joint_colour = "#d98a2b";

  const robot& robot_;
  model_options options_;
  robots::plan plan_;
  std::vector<std::string> words_{};
  std::string out_{};
};

} // namespace kanexpr::robots
