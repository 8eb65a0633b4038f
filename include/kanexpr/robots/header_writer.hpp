#pragma once

#include <kanexpr/robots/header_text.hpp>
#include <kanexpr/robots/plan.hpp>

#include <string>
#include <utility>
#include <vector>

/// A robot as a header with its model, for a compiler to derive and for a person to read and change.
namespace kanexpr::robots {

class header_writer {
public:
  header_writer(const robot& r, const model_options& options)
      : robot_(r), options_(options), plan_(plan_of(r, options)) {}

  /// Why there is no header; empty: there is one.
  const std::string& cause() const { return plan_.mistake; }

  /// The header of a model in the namespace `called`, `from` a file.
  std::string write(const std::string& called, std::string_view from) {
    frames_.resize(robot_.links.size());
    origins_.resize(robot_.links.size());
    write_root();
    for (const moving_body& b : plan_.what.bodies) {
      if (b.joint >= 0) write_joint(b);
      write_mass(b);
      if (b.joint >= 0) write_rotor(b);
      write_folded(b);
      out_ += '\n';
    }
    loads_.insert(loads_.begin(), "gravity<-" + text::factor(value("g", options_.gravity)) + " * N::z>");
    return head(called, from) + symbols() +
           "struct N : inertial_frame<N> {};\nstruct O : origin<O, N> {};\n\n" + out_ + system() + limits() +
           at_rest() + values() + "\n} // namespace " + called + "\n";
  }

private:
  /// The expressions by which a joint moves.
  struct motion {
    std::vector<std::string> q{}, u{};
    std::string drive{};
  };

  const std::string& name(int link) const { return plan_.links[static_cast<std::size_t>(link)]; }
  std::string& frame(int link) { return frames_[static_cast<std::size_t>(link)]; }
  std::string& origin(int link) { return origins_[static_cast<std::size_t>(link)]; }
  const joint& joint_of(const moving_body& b) const {
    return robot_.joints[static_cast<std::size_t>(b.joint)];
  }
  const moving_body& parent_of(const moving_body& b) const {
    return plan_.what.bodies[static_cast<std::size_t>(b.parent)];
  }

  void write_struct(const std::string& called, const std::string& word, const std::string& arguments,
                    const std::string& more = {}) {
    const std::string what = " : " + word + "<" + called + ", " + arguments + ">" + more + " {};";
    const bool fits = called.size() + what.size() + 7 <= text::columns;
    out_ += "struct " + called + (fits ? what : "\n   " + text::folded(what, 3, 4 + 3 + word.size())) + "\n";
  }

  std::string value(const std::string& called, double of_file) {
    if (options_.bind == binding::numbers) return text::digits(of_file);
    values_.emplace_back(called, of_file);
    return called;
  }

  /// The name of axes that are turned in others, which is that of these without a turn.
  std::string turned(const std::string& called, const std::string& in, const rotation& by) {
    if (by == no_rotation) return in;
    std::string cosines;
    for (const vector3& row : by)
      for (double e : row) cosines += ", " + text::digits(e);
    write_struct(called, "direction_cosines", in + cosines);
    return called;
  }
  std::string moved(const std::string& called, const std::string& from, const std::string& axes,
                    const vector3& by) {
    if (is_zero(by)) return from;
    write_struct(called, "offset", from + ", " + text::along(axes, by));
    return called;
  }

  motion motion_of(int joint) const {
    const mimicry how = followed_by(robot_, joint);
    const planned_joint& leader = *plan_.joint_by(how.leader);
    if (how.leader == joint) return {leader.coordinates, leader.speeds, leader.input};
    const auto times = [&](const std::string& e) {
      return how.multiplier == 1 ? e : text::digits(how.multiplier) + " * " + e;
    };
    const std::string behind = how.offset == 0  ? ""
                               : how.offset < 0 ? " - " + text::digits(-how.offset)
                                                : " + " + text::digits(how.offset);
    return {{times(leader.coordinates[0]) + behind}, {times(leader.speeds[0])}, {}};
  }

  void write_root() {
    const int root = plan_.what.bodies[0].link;
    frame(root) = "N", origin(root) = "O";
    if (options_.base == base_kind::floating)
      write_free(root, "N", "O", {plan_.joints[0].coordinates, plan_.joints[0].speeds, {}});
  }

  /// All that a joint becomes.
  void write_joint(const moving_body& b) {
    const moving_body& in = parent_of(b);
    const motion m = motion_of(b.joint);
    const joint& j = joint_of(b);
    const std::string& called = name(b.link);
    const std::string parent = frame(in.link), parent_origin = origin(in.link);
    out_ += "// " + text::comment(j.name) + ": from " +
            text::comment(robot_.links[static_cast<std::size_t>(in.link)].name) + " to " +
            text::comment(robot_.links[static_cast<std::size_t>(b.link)].name) + "\n";
    if (j.is == joint_kind::prismatic) {
      const std::string axes = turned(called, parent, b.origin.turn);
      const std::string start = moved(called + "_start", parent_origin, parent, b.origin.at);
      const std::string axis = text::factor(text::along(axes, j.axis));
      write_struct(called + "_origin", "offset", start + ", " + text::factor(m.q[0]) + " * " + axis);
      frame(b.link) = axes, origin(b.link) = called + "_origin";
      if (const std::string drive = driving(b, m); !drive.empty())
        loads_.push_back("force_between<" + origin(b.link) + ", " + start + ", " + text::factor(drive) +
                         " * " + axis + ">");
      return;
    }
    const std::string home = turned(called + "_home", parent, b.origin.turn);
    const std::string axis = text::along(home, j.axis);
    if (j.is == joint_kind::revolute || j.is == joint_kind::continuous) {
      write_struct(called, "rotated", home + ", " + m.q[0] + ", " + axis);
      frame(b.link) = called;
      origin(b.link) = moved(called + "_origin", parent_origin, parent, b.origin.at);
      if (const std::string drive = driving(b, m); !drive.empty())
        loads_.push_back("torque_between<" + called + ", " + parent + ", " + text::factor(drive) + " * " +
                         text::factor(axis) + ">");
      return;
    }
    const std::string start = moved(called + "_start", parent_origin, parent, b.origin.at);
    if (j.is == joint_kind::floating) return write_free(b.link, home, start, m);
    const auto [first, second] = across(j.axis);
    write_struct(called, "rotated", home + ", " + m.q[2] + ", " + axis);
    write_struct(called + "_origin", "offset",
                 start + ", " + m.q[0] + " * " + text::factor(text::along(home, first)) + " + " + m.q[1] +
                     " * " + text::factor(text::along(home, second)));
    frame(b.link) = called, origin(b.link) = called + "_origin";
  }

  void write_free(int link, const std::string& in, const std::string& start, const motion& m) {
    const std::string& called = name(link);
    const auto sum = [](const std::string& axes, const std::string& x, const std::string& y,
                        const std::string& z) {
      return x + " * " + axes + "::x + " + y + " * " + axes + "::y + " + z + " * " + axes + "::z";
    };
    write_struct(called, "quaternion", text::list({in, m.q[6], m.q[3], m.q[4], m.q[5]}),
                 ", angular_velocity<" + in + ", " + sum("own", m.u[3], m.u[4], m.u[5]) + ">");
    const std::string v = sum(called, m.u[0], m.u[1], m.u[2]);
    write_struct(called + "_origin", "offset", start + ", " + sum(in, m.q[0], m.q[1], m.q[2]),
                 ", velocity<" + in + ", " + v + ">");
    for (std::size_t i = 0; i < 3; ++i)
      kinematics_.push_back("dot(" + m.q[i] + ") == dot(" + v + ", " + in + "::" + "xyz"[i] + ")");
    kinematics_.push_back("kinematics_of<" + called + ", " + in + ">");
    frame(link) = called, origin(link) = called + "_origin";
  }

  std::string driving(const moving_body& b, const motion& m) {
    const joint& j = joint_of(b);
    std::string drive = m.drive;
    if (options_.damping && j.damping > 0)
      drive += (drive.empty() ? "-" : " - ") + value("c_" + name(b.link), j.damping) + " * " +
               text::factor(m.u[0]);
    if (options_.friction && j.friction > 0)
      drive +=
          (drive.empty() ? "-" : " - ") + value("f_" + name(b.link), j.friction) + " * sign(" + m.u[0] + ")";
    return drive;
  }

  std::string symbols_along(const std::string& axes, const std::string& called, const vector3& v) {
    const std::string x = value("x_" + called, v[0]), y = value("y_" + called, v[1]),
                      z = value("z_" + called, v[2]);
    return x + " * " + axes + "::x + " + y + " * " + axes + "::y + " + z + " * " + axes + "::z";
  }

  void write_mass(const moving_body& b) {
    const bool on_ground = b.joint < 0 && options_.base == base_kind::fixed;
    if (on_ground || !b.has_mass()) return;
    const std::string& called = name(b.link);
    const std::string axes = frame(b.link);
    const bool numbers = options_.bind == binding::numbers;
    const std::string mass = value("m_" + called, b.mass);
    std::string center = origin(b.link);
    if (!numbers || !is_zero(b.center)) {
      const std::string at = numbers ? text::along(axes, b.center) : symbols_along(axes, called, b.center);
      center = called + "_center";
      write_struct(center, "offset", origin(b.link) + ", " + at);
    }
    const inertia_matrix& i = b.inertia;
    std::vector<std::string> scalars{axes, value("ixx_" + called, i.xx), value("iyy_" + called, i.yy),
                                     value("izz_" + called, i.zz)};
    if (!numbers || i.xy != 0 || i.yz != 0 || i.zx != 0)
      for (const auto& [letters, e] : {std::pair("ixy_", i.xy), {"iyz_", i.yz}, {"izx_", i.zx}})
        scalars.push_back(value(letters + called, e));
    std::string inertia = "inertia<" + text::list(scalars) + ">";
    if (numbers && is_of_no_body(i)) inertia = "effective_inertia<" + inertia + ">";
    write_struct(called + "_body", "rigid_body", text::list({center, axes, mass, inertia}));
    bodies_.push_back(called + "_body");
  }

  /// n² J is felt at the joint, and nothing else.
  void write_rotor(const moving_body& b) {
    const joint& j = joint_of(b);
    const double felt = j.gear_ratio * j.gear_ratio * j.rotor_inertia;
    if (!(felt > 0) || !has_one_coordinate(j.is)) return;
    const std::string called = name(b.link) + "_rotor";
    write_struct(called, "rotated", "N, " + motion_of(b.joint).q[0] + ", N::z");
    write_struct(called + "_body", "rigid_body",
                 "O, " + called + ", 0, inertia<" + called + ", 0, 0, " + value("j_" + name(b.link), felt) +
                     ">");
    bodies_.push_back(called + "_body");
  }

  /// The links that are fixed to a body, and other names of the same axes and points.
  void write_folded(const moving_body& b) {
    write_alias(b.link);
    const auto body = static_cast<std::size_t>(&b - plan_.what.bodies.data());
    for (std::size_t l = 0; l < robot_.links.size(); ++l) {
      const placed_link& here = plan_.what.links[l];
      if (static_cast<std::size_t>(here.body) != body || static_cast<int>(l) == b.link) continue;
      frames_[l] = turned(plan_.links[l], frame(b.link), here.at.turn);
      origins_[l] = moved(plan_.links[l] + "_origin", origin(b.link), frame(b.link), here.at.at);
      write_alias(static_cast<int>(l));
    }
  }
  void write_alias(int link) {
    if (frame(link) != name(link)) out_ += "using " + name(link) + " = " + frame(link) + ";\n";
    if (origin(link) != name(link) + "_origin")
      out_ += "using " + name(link) + "_origin = " + origin(link) + ";\n";
  }

  std::string head(const std::string& called, std::string_view from) const {
    const std::size_t links = robot_.links.size(), joints = plan_.what.joints.size();
    const std::string include = std::string("#") + "include "; // of the header, not of this file
    return "#pragma once\n\n" + include + "<kanexpr/kanexpr.hpp>\n\n" + include +
           "<limits>\n\n/// The robot " + text::comment(robot_.name) + " of " + text::comment(from) + ": " +
           std::to_string(links) + (links == 1 ? " link, " : " links, ") + std::to_string(joints) +
           (joints == 1 ? " joint" : " joints") + " that move" + (joints == 1 ? "s" : "") +
           " by coordinates of their own, a " +
           (options_.base == base_kind::floating ? "floating" : "fixed") +
           " base.\n/// Written by kanexpr-robot.\nnamespace " + called +
           " {\n\nusing namespace kanexpr;\n\n";
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
    std::vector<std::string> q, u, r, equations = std::move(kinematics_), p;
    for (const planned_joint& j : plan_.joints) {
      q.insert(q.end(), j.coordinates.begin(), j.coordinates.end());
      u.insert(u.end(), j.speeds.begin(), j.speeds.end());
      if (!j.input.empty()) r.push_back(j.input);
      if (j.is == joint_kind::floating) continue;
      for (std::size_t i = 0; i < j.speeds.size(); ++i)
        equations.push_back("dot(" + j.coordinates[i] + ") == " + j.speeds[i]);
    }
    for (const auto& [called, number] : values_) p.push_back(called);
    std::string told = "struct System\n    : kane_system<\n          inertial<N>";
    for (const auto& [word, all] : {std::pair<const char*, const std::vector<std::string>&>("coordinates", q),
                                    {"speeds", u},
                                    {"kinematics", equations},
                                    {"parameters", p},
                                    {"inputs", r},
                                    {"bodies", bodies_},
                                    {"loads", loads_}})
      if (!all.empty()) told += ",\n" + text::wrapped(std::string(10, ' ') + word + "<", all) + ">";
    return told + "> {};\n";
  }

  /// Of the coordinates of joints, in their order.
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
        "\n/// What the file allows the joints of one coordinate, in their order.\n"
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
        "\n/// Nothing moves, and no joint is turned or moved out.\ninline state<System> at_rest() {\n";
    told += "  state<System> x = state<System>::Zero();\n";
    for (const planned_joint& j : plan_.joints)
      if (j.is == joint_kind::floating) told += "  x[" + j.coordinates.back() + "] = 1;\n";
    return told + "  return x;\n}\n";
  }

  std::string values() const {
    if (values_.empty()) return {};
    std::string told =
        "\n/// The parameters as the file has them.\ninline parameter_values<System> values() {\n"
        "  parameter_values<System> p;\n";
    for (const auto& [called, number] : values_)
      told += "  p[" + called + "] = " + text::digits(number) + ";\n";
    return told + "  return p;\n}\n";
  }

  const robot& robot_;
  model_options options_;
  robots::plan plan_;
  std::vector<std::string> frames_{}, origins_{}, kinematics_{}, bodies_{}, loads_{};
  std::vector<std::pair<std::string, double>> values_{};
  std::string out_{};
};

} // namespace kanexpr::robots
