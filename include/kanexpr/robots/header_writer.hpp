#pragma once

#include <kanexpr/robots/header_text.hpp>
#include <kanexpr/robots/plan.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// Writes the model of a robot as a header, which the compiler derives and people can read and change.
namespace kanexpr::robots {

class header_writer {
public:
  header_writer(const robot& r, const model_options& options)
      : robot_(r), options_(options), plan_(plan_of(r, options)) {}

  /// The reason why there is no header; empty if there is one.
  std::string cause() const { return plan_.mistake; }

  /// The names that differ between the file and C++: "Finger_a is finger a, …".
  std::string renamed() const { return text::list(plan_.renamed); }

  /// Returns the header of a model in the namespace `called`; the robot was read from the file `from`.
  std::string write(const std::string& called, std::string_view from) {
    links_.resize(robot_.links.size());
    write_root();
    for (const moving_body& b : plan_.what.bodies) {
      if (b.joint >= 0) write_joint(b);
      if (b.joint >= 0) write_rotor(b);
      write_folded(b);
      out_ += '\n';
    }
    write_gravity();
    return head(called, from) + symbols() +
           "/// The ground, its axes and its origin.\nstruct N : inertial_ground<N> {};\n\n" + out_ +
           system() + limits() + at_rest() + values() + "\n} // namespace " + called + "\n";
  }

private:
  /// The coordinate and the speed of a joint with one coordinate, as expressions.
  struct motion {
    std::string q{}, u{};
  };

  const std::string& name(int link) const { return plan_.links[static_cast<std::size_t>(link)]; }
  /// The type that has the axes and the origin of a link; N for a link that coincides with the ground.
  std::string& type(int link) { return links_[static_cast<std::size_t>(link)]; }
  const joint& joint_of(const moving_body& b) const {
    return robot_.joints[static_cast<std::size_t>(b.joint)];
  }
  const moving_body& parent_of(const moving_body& b) const {
    return plan_.what.bodies[static_cast<std::size_t>(b.parent)];
  }

  void write_gravity() {
    const std::string free_fall = gravity();
    loads_.insert(loads_.begin(), "gravity<" + free_fall + ">");
    if (options_.bind == binding::numbers && is_zero(gravity_of(robot_, options_))) return;
    std::string lifting;
    for (const moving_body& b : plan_.what.bodies)
      if (b.weightless > 0 && !(b.joint < 0 && options_.base == base_kind::fixed))
        lifting += (lifting.empty() ? "" : " + ") + energy_of_lifting(b, free_fall);
    if (!lifting.empty())
      loads_.push_back("potential_energy<" + lifting + ">"); // one sum: wheels have equal terms
  }

  /// A potential energy that cancels gravity on a weightless body, so that energy is conserved.
  std::string energy_of_lifting(const moving_body& b, const std::string& free_fall) {
    const std::string &on = type(b.link), called = name(b.link) + "_weightless";
    const std::string symbols =
        b.is_weightless() ? name(b.link) : called; // the existing axes if the whole body is weightless
    const auto known = values_.size();
    const std::string mass = value("m_" + symbols, b.weightless);
    const std::string at = options_.bind == binding::numbers
                               ? text::along(on, b.weightless_center)
                               : symbols_along(on, symbols, b.weightless_center);
    if (b.is_weightless()) values_.resize(known);
    write_struct(called, "offset", {on, at});
    return mass + " * dot(" + free_fall + ", position_of<" + called + ", N>)";
  }

  std::string gravity() {
    const vector3 g = gravity_of(robot_, options_), to = direction_of_gravity(g);
    const std::string size = value("g", std::hypot(g[0], g[1], g[2]));
    if (options_.bind == binding::numbers && is_zero(g)) return text::along("N", {});
    if (to == vector3{0, 0, -1}) return "-" + size + " * N::z";
    return options_.bind == binding::numbers ? text::along("N", g)
                                             : size + " * " + text::factor(text::along("N", to));
  }

  std::string value(const std::string& called, double of_file) {
    if (options_.bind == binding::numbers) return text::digits(of_file);
    values_.emplace_back(called, of_file);
    return called;
  }

  void write_struct(const std::string& called, const std::string& word,
                    const std::vector<std::string>& arguments) {
    std::vector<std::string> all{called};
    all.insert(all.end(), arguments.begin(), arguments.end());
    out_ += text::wrapped("struct " + called + " : " + word + "<", all) + "> {};\n";
  }

  /// The arguments that place a joint in its parent; a zero offset or rotation is omitted.
  static std::vector<std::string> placed(const std::string& parent, const pose& origin) {
    std::vector<std::string> words{parent};
    if (!is_zero(origin.at)) words.push_back("at<" + text::along(parent, origin.at) + ">");
    if (origin.turn == no_rotation) return words;
    std::vector<std::string> cosines;
    for (const vector3& row : origin.turn)
      for (double e : row) cosines.push_back(text::digits(e));
    words.push_back("home<" + text::list(cosines) + ">");
    return words;
  }

  motion motion_of(int joint) const {
    const mimicry how = followed_by(robot_, joint);
    const planned_joint& leader = *plan_.joint_by(how.leader);
    const auto times = [&](const std::string& e) {
      return how.multiplier == 1 ? e : text::digits(how.multiplier) + " * " + e;
    };
    const std::string behind = how.offset == 0  ? ""
                               : how.offset < 0 ? " - " + text::digits(-how.offset)
                                                : " + " + text::digits(how.offset);
    return {times(leader.coordinates[0]) + behind, times(leader.speeds[0])};
  }

  void write_root() {
    const moving_body& root = plan_.what.bodies[0];
    type(root.link) = "N";
    if (options_.base == base_kind::floating) write_joint_by(root, "floating", {"N"}, plan_.joints[0]);
  }

  /// Writes a joint as one declaration with its symbols and its body.
  void write_joint_by(const moving_body& b, const std::string& word, std::vector<std::string> words,
                      const planned_joint& j) {
    std::vector<std::string> symbols = j.coordinates;
    symbols.insert(symbols.end(), j.speeds.begin(), j.speeds.end());
    words.push_back("by<" + text::list(symbols) + ">");
    if (b.has_mass()) words.push_back(body_of(b));
    type(b.link) = name(b.link);
    write_struct(name(b.link), word, words);
  }

  void write_joint(const moving_body& b) {
    const moving_body& in = parent_of(b);
    const joint& j = joint_of(b);
    out_ += "// " + text::comment(j.name) + ": from " +
            text::comment(robot_.links[static_cast<std::size_t>(in.link)].name) + " to " +
            text::comment(robot_.links[static_cast<std::size_t>(b.link)].name) + "\n";
    if (j.mimic) return write_follower(b);
    const auto [word, axes] = joint_word(j);
    std::vector<std::string> words = placed(type(in.link), b.origin);
    if (!axes.empty()) words.insert(words.begin() + 1, axes);
    write_joint_by(b, word, words, *plan_.joint_by(b.joint));
    if (has_one_coordinate(j.is)) write_drive(b);
  }

  static std::pair<std::string, std::string> joint_word(const joint& j) {
    if (j.is == joint_kind::floating) return {"floating", ""};
    if (j.is == joint_kind::planar) {
      const auto [first, second] = across(j.axis);
      return {"planar", "axis<" + text::list({text::along("own", first), text::along("own", second)}) + ">"};
    }
    return {j.is == joint_kind::prismatic ? "prismatic" : "pin", "axis<" + text::along("own", j.axis) + ">"};
  }

  void write_drive(const moving_body& b) {
    const joint& j = joint_of(b);
    const planned_joint& by = *plan_.joint_by(b.joint);
    std::string drive = by.input;
    if (const std::string rubbed = friction(b, by.speeds[0]); !rubbed.empty()) drive += " - " + rubbed;
    loads_.push_back("motor<" + name(b.link) + ", " + drive + ">");
    if (options_.damping && j.damping > 0)
      loads_.push_back("joint_friction<" + name(b.link) + ", " + value("c_" + name(b.link), j.damping) + ">");
  }

  std::string friction(const moving_body& b, const std::string& speed) {
    const joint& j = joint_of(b);
    if (!options_.friction || !(j.friction > 0)) return {};
    return value("f_" + name(b.link), j.friction) + " * sign(" + speed + ")";
  }

  /// Writes a mimic joint as a weld whose location depends on the coordinate of its leader.
  void write_follower(const moving_body& b) {
    const joint& j = joint_of(b);
    const std::string &called = name(b.link), start = called + "_start";
    const motion m = motion_of(b.joint);
    write_weld(start, placed(type(parent_of(b).link), b.origin));
    const std::string axis = text::along(start, j.axis);
    const bool slides = j.is == joint_kind::prismatic;
    std::vector<std::string> words{start, slides
                                              ? "at<" + text::factor(m.q) + " * " + text::factor(axis) + ">"
                                              : "home<" + m.q + ", " + axis + ">"};
    if (b.has_mass()) words.push_back(body_of(b));
    type(b.link) = called;
    write_weld(called, words);
    std::string drag;
    if (options_.damping && j.damping > 0)
      drag += "-" + value("c_" + called, j.damping) + " * " + text::factor(m.u);
    if (const std::string rubbed = friction(b, m.u); !rubbed.empty())
      drag += (drag.empty() ? "-" : " - ") + rubbed;
    if (!drag.empty())
      loads_.push_back(std::string(slides ? "force" : "torque") + "_between<" + called + ", " + start + ", " +
                       text::factor(drag) + " * " + text::factor(axis) + ">");
  }

  void write_weld(const std::string& called, const std::vector<std::string>& words) {
    write_struct(called, "weld", words);
    welds_.push_back(called);
  }

  std::string symbols_along(const std::string& axes, const std::string& called, const vector3& v) {
    const std::string x = value("x_" + called, v[0]), y = value("y_" + called, v[1]),
                      z = value("z_" + called, v[2]);
    return x + " * " + axes + "::x + " + y + " * " + axes + "::y + " + z + " * " + axes + "::z";
  }

  std::string body_of(const moving_body& b) {
    const std::string& called = name(b.link);
    const bool numbers = options_.bind == binding::numbers;
    const std::string mass = value("m_" + called, b.mass);
    const std::string center =
        numbers ? text::along("own", b.center) : symbols_along("own", called, b.center);
    const inertia_matrix& i = b.inertia;
    std::vector<std::string> scalars{"own", value("ixx_" + called, i.xx), value("iyy_" + called, i.yy),
                                     value("izz_" + called, i.zz)};
    if (!numbers || i.xy != 0 || i.yz != 0 || i.zx != 0)
      for (const auto& [letters, e] : {std::pair("ixy_", i.xy), {"iyz_", i.yz}, {"izx_", i.zx}})
        scalars.push_back(value(letters + called, e));
    std::string inertia = "inertia<" + text::list(scalars) + ">";
    if (is_of_no_body(i)) inertia = "effective_inertia<" + inertia + ">";
    return "body<" + text::list({mass, center, inertia}) + ">";
  }

  /// Writes a rotor, which contributes n² J at the joint and nothing else.
  void write_rotor(const moving_body& b) {
    const joint& j = joint_of(b);
    const double felt = j.gear_ratio * j.gear_ratio * j.rotor_inertia;
    if (!(felt > 0) || !has_one_coordinate(j.is)) return;
    const std::string called = name(b.link) + "_rotor";
    write_struct(called, "rotated", {"N", motion_of(b.joint).q, "N::z"});
    write_struct(
        called + "_body", "rigid_body",
        {"N", called, "0", "inertia<" + called + ", 0, 0, " + value("j_" + name(b.link), felt) + ">"});
    bodies_.push_back(called + "_body");
  }

  /// Writes the links that are fixed to a body, and aliases of the ground.
  void write_folded(const moving_body& b) {
    if (type(b.link) != name(b.link)) out_ += "using " + name(b.link) + " = " + type(b.link) + ";\n";
    const auto body = static_cast<std::size_t>(&b - plan_.what.bodies.data());
    for (std::size_t l = 0; l < robot_.links.size(); ++l) {
      const placed_link& here = plan_.what.links[l];
      if (static_cast<std::size_t>(here.body) == body && static_cast<int>(l) != b.link)
        write_weld(plan_.links[l], placed(type(b.link), here.at));
    }
  }

  std::string head(const std::string& called, std::string_view from) const {
    const std::size_t links = robot_.links.size(), joints = plan_.what.joints.size();
    const std::string include = std::string("#") + "include "; // in the header, not in this file
    return "#pragma once\n\n" + include + "<kanexpr/joints.hpp>\n" + include + "<kanexpr/kanexpr.hpp>\n\n" +
           include + "<limits>\n\n/// The robot " + text::comment(robot_.name) + " from " +
           text::comment(from) + ": " + std::to_string(links) + (links == 1 ? " link, " : " links, ") +
           std::to_string(joints) + (joints == 1 ? " joint" : " joints") + " that move" +
           (joints == 1 ? "s" : "") + " independently, a " +
           (options_.base == base_kind::floating ? "floating" : "fixed") +
           " base.\n/// Written by kanexpr-robot.\n" + names() +
           text::opened(called, {"at",
                                 "axis",
                                 "bodies",
                                 "body",
                                 "by",
                                 "coordinate",
                                 "dot",
                                 "effective_inertia",
                                 "floating",
                                 "force_between",
                                 "gravity",
                                 "home",
                                 "inertia",
                                 "inertial",
                                 "inertial_ground",
                                 "input",
                                 "inputs",
                                 "joint_friction",
                                 "joints",
                                 "kane_system",
                                 "loads",
                                 "motor",
                                 "offset",
                                 "own",
                                 "parameter",
                                 "parameter_values",
                                 "parameters",
                                 "pin",
                                 "planar",
                                 "position_of",
                                 "potential_energy",
                                 "prismatic",
                                 "rigid_body",
                                 "rotated",
                                 "sign",
                                 "speed",
                                 "state",
                                 "torque_between",
                                 "weld"});
  }

  std::string names() const {
    if (plan_.renamed.empty()) return {};
    std::vector<std::string> all;
    all.reserve(plan_.renamed.size());
    for (const std::string& each : plan_.renamed) all.push_back(text::comment(each));
    std::string told = text::wrapped("/// Names in the file: ", all) + ".\n";
    for (std::size_t at = told.find('\n'); at + 1 < told.size(); at = told.find('\n', at + 1))
      told.replace(at + 1, 3, "///");
    return told;
  }

  std::string symbols() const {
    std::string told;
    const auto one = [&](const char* word, const std::string& called) {
      told += std::string("constexpr ") + word + "<\"" + called + "\"> " + called + ";\n";
    };
    for (const planned_joint& j : plan_.joints) {
      for (const std::string& q : j.coordinates) one("coordinate", q);
      for (const std::string& u : j.speeds) one("speed", u);
      if (!j.input.empty()) one("input", j.input);
    }
    for (const auto& [called, number] : values_) one("parameter", called);
    return told + "\n";
  }

  std::string system() {
    std::vector<std::string> inputs, p, joints;
    for (const planned_joint& j : plan_.joints) {
      const int child = j.joint < 0 ? robot_.root : robot_.joints[static_cast<std::size_t>(j.joint)].child;
      joints.push_back(name(child));
      if (!j.input.empty()) inputs.push_back(j.input);
    }
    joints.insert(joints.end(), welds_.begin(), welds_.end());
    for (const auto& [called, number] : values_) p.push_back(called);
    std::string told = "struct System\n    : kane_system<\n          inertial<N>";
    for (const auto& [word, all] : {std::pair<const char*, const std::vector<std::string>&>("joints", joints),
                                    {"parameters", p},
                                    {"inputs", inputs},
                                    {"bodies", bodies_},
                                    {"loads", loads_}})
      if (!all.empty()) told += ",\n" + text::wrapped(std::string(10, ' ') + word + "<", all) + ">";
    return told + "> {};\n";
  }

  /// Writes the limits of the joints with one coordinate, in their order.
  std::string limits() const {
    std::vector<std::string> lower, upper, effort, velocity;
    for (const planned_joint& j : plan_.joints) {
      if (j.joint < 0 || !has_one_coordinate(j.is)) continue;
      const joint_limits& l = robot_.joints[static_cast<std::size_t>(j.joint)].limits;
      lower.push_back(text::limit(l.lower)), upper.push_back(text::limit(l.upper));
      effort.push_back(text::limit(l.effort)), velocity.push_back(text::limit(l.velocity));
    }
    if (lower.empty()) return {};
    std::string told =
        "\n/// The limits of the joints with one coordinate, in their order.\n"
        "struct limits {\n  static constexpr double no_limit = std::numeric_limits<double>::infinity();\n";
    for (const auto& [called, all] : {std::pair<const char*, const std::vector<std::string>&>("lower", lower),
                                      {"upper", upper},
                                      {"effort", effort},
                                      {"velocity", velocity}})
      told += text::wrapped(std::string("  static constexpr double ") + called + "[]{", all) + "};\n";
    return told + "};\n";
  }

  std::string at_rest() const {
    std::string told =
        "\n/// The state at rest in which all joint positions are zero.\ninline state<System> at_rest() {\n";
    told += "  state<System> x = state<System>::Zero();\n";
    for (const planned_joint& j : plan_.joints)
      if (j.is == joint_kind::floating) told += "  x[" + j.coordinates.back() + "] = 1;\n";
    return told + "  return x;\n}\n";
  }

  std::string values() const {
    if (values_.empty()) return {};
    std::string told =
        "\n/// The values of the parameters in the file.\ninline parameter_values<System> values() {\n"
        "  parameter_values<System> p;\n";
    for (const auto& [called, number] : values_)
      told += "  p[" + called + "] = " + text::digits(number) + ";\n";
    return told + "  return p;\n}\n";
  }

  const robot& robot_;
  model_options options_;
  robots::plan plan_;
  std::vector<std::string> links_{}, welds_{}, bodies_{}, loads_{};
  std::vector<std::pair<std::string, double>> values_{};
  std::string out_{};
};

} // namespace kanexpr::robots
