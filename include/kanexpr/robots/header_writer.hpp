#pragma once

#include <kanexpr/robots/write_gravity.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Writes the model of a robot as a header, which the compiler derives and people can read and change.
namespace kanexpr::robots {

class header_writer {
public:
  header_writer(const robot& r, const model_options& options) : draft_(r, options) {}

  /// The reason why there is no header; empty if there is one.
  std::string cause() const { return draft_.plan.mistake; }

  /// The names that differ between the file and C++: "Finger_a is finger a, …".
  std::string renamed() const { return header_text::list(draft_.plan.renamed); }

  /// Returns the header of a model in the namespace `called`; the robot was read from the file `from`.
  std::string write(const std::string& called, std::string_view from) {
    write_root();
    for (const moving_body& b : draft_.plan.what.bodies) {
      if (b.joint >= 0) write_joint(b);
      if (b.joint >= 0) write_rotor(b);
      write_folded(b);
      draft_.declarations += '\n';
    }
    write_gravity(draft_);
    return head(called, from) + symbols() +
           "/// The ground, its axes and its origin.\nstruct N : inertial_ground<N> {};\n\n" +
           draft_.declarations + system() + limits() + at_rest() + values() + "\n} // namespace " + called +
           "\n";
  }

private:
  /// The coordinate and the speed of a joint with one coordinate, as expressions.
  struct motion {
    std::string q{}, u{};
  };

  const joint& joint_of(const moving_body& b) const {
    return draft_.source.joints[static_cast<std::size_t>(b.joint)];
  }
  const moving_body& parent_of(const moving_body& b) const {
    return draft_.plan.what.bodies[static_cast<std::size_t>(b.parent)];
  }

  /// The arguments that place a joint in its parent; a zero offset or rotation is omitted.
  static std::vector<std::string> placed(const std::string& parent, const pose& origin) {
    std::vector<std::string> words{parent};
    if (!is_zero(origin.at)) words.push_back("at<" + header_text::along(parent, origin.at) + ">");
    if (origin.turn == no_rotation) return words;
    std::vector<std::string> cosines;
    for (const vector3& row : origin.turn)
      for (double e : row) cosines.push_back(header_text::digits(e));
    words.push_back("home<" + header_text::list(cosines) + ">");
    return words;
  }

  motion motion_of(int joint) const {
    const mimicry how = followed_by(draft_.source, joint);
    const planned_joint& leader = *draft_.plan.joint_by(how.leader);
    const auto times = [&](const std::string& e) {
      return how.multiplier == 1 ? e : header_text::digits(how.multiplier) + " * " + e;
    };
    const std::string behind = how.offset == 0  ? ""
                               : how.offset < 0 ? " - " + header_text::digits(-how.offset)
                                                : " + " + header_text::digits(how.offset);
    return {times(leader.coordinates[0]) + behind, times(leader.speeds[0])};
  }

  void write_root() {
    const moving_body& root = draft_.plan.what.bodies[0];
    draft_.type(root.link) = "N";
    if (draft_.options.base == base_kind::floating)
      write_joint_by(root, "floating", {"N"}, draft_.plan.joints[0]);
  }

  /// Writes a joint as one declaration with its symbols and its body.
  void write_joint_by(const moving_body& b, const std::string& word, std::vector<std::string> words,
                      const planned_joint& j) {
    std::vector<std::string> symbols = j.coordinates;
    symbols.insert(symbols.end(), j.speeds.begin(), j.speeds.end());
    words.push_back("by<" + header_text::list(symbols) + ">");
    if (b.has_mass()) words.push_back(body_of(b));
    draft_.type(b.link) = draft_.name(b.link);
    draft_.write_struct(draft_.name(b.link), word, words);
  }

  void write_joint(const moving_body& b) {
    const moving_body& in = parent_of(b);
    const joint& j = joint_of(b);
    draft_.declarations +=
        "// " + header_text::comment(j.name) + ": from " +
        header_text::comment(draft_.source.links[static_cast<std::size_t>(in.link)].name) + " to " +
        header_text::comment(draft_.source.links[static_cast<std::size_t>(b.link)].name) + "\n";
    if (j.mimic) return write_follower(b);
    const auto [word, axes] = joint_word(j);
    std::vector<std::string> words = placed(draft_.type(in.link), b.origin);
    if (!axes.empty()) words.insert(words.begin() + 1, axes);
    write_joint_by(b, word, words, *draft_.plan.joint_by(b.joint));
    if (has_one_coordinate(j.is)) write_drive(b);
  }

  static std::pair<std::string, std::string> joint_word(const joint& j) {
    if (j.is == joint_kind::floating) return {"floating", ""};
    if (j.is == joint_kind::planar) {
      const auto [first, second] = across(j.axis);
      return {"planar",
              "axis<" +
                  header_text::list({header_text::along("own", first), header_text::along("own", second)}) +
                  ">"};
    }
    return {j.is == joint_kind::prismatic ? "prismatic" : "pin",
            "axis<" + header_text::along("own", j.axis) + ">"};
  }

  void write_drive(const moving_body& b) {
    const joint& j = joint_of(b);
    const planned_joint& by = *draft_.plan.joint_by(b.joint);
    std::string drive = by.input;
    if (const std::string rubbed = friction(b, by.speeds[0]); !rubbed.empty()) drive += " - " + rubbed;
    draft_.loads.push_back("motor<" + draft_.name(b.link) + ", " + drive + ">");
    if (draft_.options.damping && j.damping > 0)
      draft_.loads.push_back("joint_friction<" + draft_.name(b.link) + ", " +
                             draft_.value("c_" + draft_.name(b.link), j.damping) + ">");
  }

  std::string friction(const moving_body& b, const std::string& speed) {
    const joint& j = joint_of(b);
    if (!draft_.options.friction || !(j.friction > 0)) return {};
    return draft_.value("f_" + draft_.name(b.link), j.friction) + " * sign(" + speed + ")";
  }

  /// Writes a mimic joint as a weld whose location depends on the coordinate of its leader.
  void write_follower(const moving_body& b) {
    const joint& j = joint_of(b);
    const std::string &called = draft_.name(b.link), start = called + "_start";
    const motion m = motion_of(b.joint);
    write_weld(start, placed(draft_.type(parent_of(b).link), b.origin));
    const std::string axis = header_text::along(start, j.axis);
    const bool slides = j.is == joint_kind::prismatic;
    std::vector<std::string> words{start, slides ? "at<" + header_text::factor(m.q) + " * " +
                                                       header_text::factor(axis) + ">"
                                                 : "home<" + m.q + ", " + axis + ">"};
    if (b.has_mass()) words.push_back(body_of(b));
    draft_.type(b.link) = called;
    write_weld(called, words);
    std::string drag;
    if (draft_.options.damping && j.damping > 0)
      drag += "-" + draft_.value("c_" + called, j.damping) + " * " + header_text::factor(m.u);
    if (const std::string rubbed = friction(b, m.u); !rubbed.empty())
      drag += (drag.empty() ? "-" : " - ") + rubbed;
    if (!drag.empty())
      draft_.loads.push_back(std::string(slides ? "force" : "torque") + "_between<" + called + ", " + start +
                             ", " + header_text::factor(drag) + " * " + header_text::factor(axis) + ">");
  }

  void write_weld(const std::string& called, const std::vector<std::string>& words) {
    draft_.write_struct(called, "weld", words);
    welds_.push_back(called);
  }

  std::string body_of(const moving_body& b) {
    const std::string& called = draft_.name(b.link);
    const bool numbers = draft_.options.bind == binding::numbers;
    const std::string mass = draft_.value("m_" + called, b.mass);
    const std::string center =
        numbers ? header_text::along("own", b.center) : draft_.symbols_along("own", called, b.center);
    const inertia_matrix& i = b.inertia;
    std::vector<std::string> scalars{"own", draft_.value("ixx_" + called, i.xx),
                                     draft_.value("iyy_" + called, i.yy),
                                     draft_.value("izz_" + called, i.zz)};
    if (!numbers || i.xy != 0 || i.yz != 0 || i.zx != 0)
      for (const auto& [letters, e] : {std::pair("ixy_", i.xy), {"iyz_", i.yz}, {"izx_", i.zx}})
        scalars.push_back(draft_.value(letters + called, e));
    std::string inertia = "inertia<" + header_text::list(scalars) + ">";
    if (is_of_no_body(i)) inertia = "effective_inertia<" + inertia + ">";
    return "body<" + header_text::list({mass, center, inertia}) + ">";
  }

  /// Writes a rotor, which contributes n² J at the joint and nothing else.
  void write_rotor(const moving_body& b) {
    const joint& j = joint_of(b);
    const double felt = j.gear_ratio * j.gear_ratio * j.rotor_inertia;
    if (!(felt > 0) || !has_one_coordinate(j.is)) return;
    const std::string called = draft_.name(b.link) + "_rotor";
    draft_.write_struct(called, "rotated", {"N", motion_of(b.joint).q, "N::z"});
    draft_.write_struct(
        called + "_body", "rigid_body",
        {"N", called, "0",
         "inertia<" + called + ", 0, 0, " + draft_.value("j_" + draft_.name(b.link), felt) + ">"});
    bodies_.push_back(called + "_body");
  }

  /// Writes the links that are fixed to a body, and aliases of the ground.
  void write_folded(const moving_body& b) {
    if (draft_.type(b.link) != draft_.name(b.link))
      draft_.declarations += "using " + draft_.name(b.link) + " = " + draft_.type(b.link) + ";\n";
    const auto body = static_cast<std::size_t>(&b - draft_.plan.what.bodies.data());
    for (std::size_t l = 0; l < draft_.source.links.size(); ++l) {
      const placed_link& here = draft_.plan.what.links[l];
      if (static_cast<std::size_t>(here.body) == body && static_cast<int>(l) != b.link)
        write_weld(draft_.plan.links[l], placed(draft_.type(b.link), here.at));
    }
  }

  std::string head(const std::string& called, std::string_view from) const {
    const std::size_t links = draft_.source.links.size(), joints = draft_.plan.what.joints.size();
    const std::string include = std::string("#") + "include "; // in the header, not in this file
    return "#pragma once\n\n" + include + "<kanexpr/joints.hpp>\n" + include + "<kanexpr/kanexpr.hpp>\n\n" +
           include + "<limits>\n\n/// The robot " + header_text::comment(draft_.source.name) + " from " +
           header_text::comment(from) + ": " + std::to_string(links) + (links == 1 ? " link, " : " links, ") +
           std::to_string(joints) + (joints == 1 ? " joint" : " joints") + " that move" +
           (joints == 1 ? "s" : "") + " independently, a " +
           (draft_.options.base == base_kind::floating ? "floating" : "fixed") +
           " base.\n/// Written by kanexpr-robot.\n" + names() +
           header_text::opened(called, {"at",
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
    if (draft_.plan.renamed.empty()) return {};
    std::vector<std::string> all;
    all.reserve(draft_.plan.renamed.size());
    for (const std::string& each : draft_.plan.renamed) all.push_back(header_text::comment(each));
    std::string told = header_text::wrapped("/// Names in the file: ", all) + ".\n";
    for (std::size_t at = told.find('\n'); at + 1 < told.size(); at = told.find('\n', at + 1))
      told.replace(at + 1, 3, "///");
    return told;
  }

  std::string symbols() const {
    std::string told;
    const auto one = [&](const char* word, const std::string& called) {
      told += std::string("constexpr ") + word + "<\"" + called + "\"> " + called + ";\n";
    };
    for (const planned_joint& j : draft_.plan.joints) {
      for (const std::string& q : j.coordinates) one("coordinate", q);
      for (const std::string& u : j.speeds) one("speed", u);
      if (!j.input.empty()) one("input", j.input);
    }
    for (const auto& [called, number] : draft_.values) one("parameter", called);
    return told + "\n";
  }

  std::string system() {
    std::vector<std::string> inputs, p, joints;
    for (const planned_joint& j : draft_.plan.joints) {
      const int child =
          j.joint < 0 ? draft_.source.root : draft_.source.joints[static_cast<std::size_t>(j.joint)].child;
      joints.push_back(draft_.name(child));
      if (!j.input.empty()) inputs.push_back(j.input);
    }
    joints.insert(joints.end(), welds_.begin(), welds_.end());
    for (const auto& [called, number] : draft_.values) p.push_back(called);
    std::string told = "struct System\n    : kane_system<\n          inertial<N>";
    for (const auto& [word, all] : {std::pair<const char*, const std::vector<std::string>&>("joints", joints),
                                    {"parameters", p},
                                    {"inputs", inputs},
                                    {"bodies", bodies_},
                                    {"loads", draft_.loads}})
      if (!all.empty()) told += ",\n" + header_text::wrapped(std::string(10, ' ') + word + "<", all) + ">";
    return told + "> {};\n";
  }

  /// Writes the limits of the joints with one coordinate, in their order.
  std::string limits() const {
    std::vector<std::string> lower, upper, effort, velocity;
    for (const planned_joint& j : draft_.plan.joints) {
      if (j.joint < 0 || !has_one_coordinate(j.is)) continue;
      const joint_limits& l = draft_.source.joints[static_cast<std::size_t>(j.joint)].limits;
      lower.push_back(header_text::limit(l.lower)), upper.push_back(header_text::limit(l.upper));
      effort.push_back(header_text::limit(l.effort)), velocity.push_back(header_text::limit(l.velocity));
    }
    if (lower.empty()) return {};
    std::string told =
        "\n/// The limits of the joints with one coordinate, in their order.\n"
        "struct limits {\n  static constexpr double no_limit = std::numeric_limits<double>::infinity();\n";
    for (const auto& [called, all] : {std::pair<const char*, const std::vector<std::string>&>("lower", lower),
                                      {"upper", upper},
                                      {"effort", effort},
                                      {"velocity", velocity}})
      told += header_text::wrapped(std::string("  static constexpr double ") + called + "[]{", all) + "};\n";
    return told + "};\n";
  }

  std::string at_rest() const {
    std::string told =
        "\n/// The state at rest in which all joint positions are zero.\ninline state<System> at_rest() {\n";
    told += "  state<System> x = state<System>::Zero();\n";
    for (const planned_joint& j : draft_.plan.joints)
      if (j.is == joint_kind::floating) told += "  x[" + j.coordinates.back() + "] = 1;\n";
    return told + "  return x;\n}\n";
  }

  std::string values() const {
    if (draft_.values.empty()) return {};
    std::string told =
        "\n/// The values of the parameters in the file.\ninline parameter_values<System> values() {\n"
        "  parameter_values<System> p;\n";
    for (const auto& [called, number] : draft_.values)
      told += "  p[" + called + "] = " + header_text::digits(number) + ";\n";
    return told + "  return p;\n}\n";
  }

  header_draft draft_;
  std::vector<std::string> welds_{}, bodies_{};
};

} // namespace kanexpr::robots
