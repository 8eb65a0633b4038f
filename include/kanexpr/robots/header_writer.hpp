#pragma once

#include <kanexpr/robots/cpp.hpp>
#include <kanexpr/robots/joint_constants.hpp>
#include <kanexpr/robots/physical_quantity.hpp>
#include <kanexpr/robots/plan.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::robots {

/// Writes the model of a robot as a header, which people can read and change before the compiler derives it.
class header_writer {
public:
  header_writer(const robot& r, const model_options& options)
      : source_(r), plan_(plan_of(r, options)), types_(r.links.size()) {}

  /// The reason why there is no header; empty if there is one.
  std::string cause() const { return plan_.mistake; }

  /// The names that differ between the file and C++: "Finger_a is finger a, …".
  std::string renamed() const { return cpp::list(plan_.renamed); }

  /// Returns the header of a model in the namespace `called`; the robot was read from the file `from`.
  std::string write(const std::string& called, std::string_view from) {
    if (called == "units") units_ = "kanexpr::units::implied::"; // the namespace hides the other
    write_root();
    for (const moving_body& b : plan_.tree.bodies) {
      if (b.joint >= 0) write_joint(b);
      if (b.joint >= 0) write_rotor(b);
      write_fixed_links(b);
      declarations_ += '\n';
    }
    write_gravity();
    return preamble(called, from) + symbols() +
           "/// The ground, its axes and its origin.\nstruct N : inertial_ground<N> {};\n\n" + declarations_ +
           system() + limits_of(plan_, source_) + at_rest_of(plan_) + values() + "\n} // namespace " +
           called + "\n";
  }

private:
  using kind = physical_quantity;

  /// The coordinate and the speed of a joint with one coordinate, as expressions.
  struct motion {
    std::string q{}, u{};
  };

  /// The type that has the axes and the origin of a link; N for a link that coincides with the ground.
  std::string& type(int link) { return entry(types_, link); }

  /// Returns a number from the file, or the name of a parameter with that value.
  std::string value(const std::string& called, double in_file, kind q) {
    if (plan_.binds_numbers()) return cpp::number(in_file);
    values_.push_back({{called, q}, in_file});
    return called;
  }
  /// The same for a value that is a factor: a number is written with its unit.
  std::string factor(const std::string& called, double in_file, kind q) {
    if (plan_.binds_numbers()) return with_unit(in_file, q);
    return value(called, in_file, q);
  }
  std::string with_unit(double number, kind q) const {
    return "constant<" + cpp::number(number) + ", " + unit(q) + ">";
  }
  std::string unit(kind q) const { return units_ + std::string(name_of(q)); }

  /// Returns a vector from the file, as an expression in `axes`.
  std::string vector(const std::string& axes, const std::string& called, const vector3& v) {
    if (plan_.binds_numbers()) return cpp::along(axes, v);
    const std::string x = value("x_" + called, v[0], kind::length),
                      y = value("y_" + called, v[1], kind::length),
                      z = value("z_" + called, v[2], kind::length);
    return x + " * " + axes + "::x + " + y + " * " + axes + "::y + " + z + " * " + axes + "::z";
  }

  void write_struct(const std::string& called, const std::string& word,
                    const std::vector<std::string>& arguments) {
    std::vector<std::string> all{called};
    all.insert(all.end(), arguments.begin(), arguments.end());
    declarations_ += cpp::wrapped("struct " + called + " : " + word + "<", all) + "> {};\n";
  }

  /// The arguments that place a joint relative to its parent; a zero offset or rotation is omitted.
  static std::vector<std::string> placed(const std::string& parent, const pose& origin) {
    std::vector<std::string> words{parent};
    if (!is_zero(origin.position)) words.push_back("at<" + cpp::along(parent, origin.position) + ">");
    if (origin.orientation != no_rotation) words.push_back("home<" + cpp::list(origin.orientation) + ">");
    return words;
  }

  motion motion_of(int joint) const {
    const mimic_rule rule = resolved_mimic(source_, joint);
    const planned_joint& leader = *plan_.joint_by(rule.leader);
    const kind multiplier = plan_.multiplier_of(joint);
    const auto times = [&](const planned_symbol& e) {
      if (multiplier != kind::ratio) return with_unit(rule.multiplier, multiplier) + " * " + e.called;
      return rule.multiplier == 1 ? e.called : cpp::number(rule.multiplier) + " * " + e.called;
    };
    std::string offset;
    if (rule.offset != 0) offset = (rule.offset < 0 ? " - " : " + ") + cpp::number(std::abs(rule.offset));
    return {times(leader.coordinates[0]) + offset, times(leader.speeds[0])};
  }

  void write_root() {
    const moving_body& root = plan_.tree.bodies[0];
    type(root.link) = "N";
    if (plan_.has_floating_base()) write_joint_by(root, "floating", {"N"}, plan_.joints[0]);
  }

  /// Writes a joint as one declaration with its symbols and its body.
  void write_joint_by(const moving_body& b, const std::string& word, std::vector<std::string> words,
                      const planned_joint& j) {
    std::vector<std::string> symbols;
    for (const auto* all : {&j.coordinates, &j.speeds})
      for (const planned_symbol& each : *all) symbols.push_back(each.called);
    words.push_back("by<" + cpp::list(symbols) + ">");
    if (b.has_mass()) words.push_back(body_of(b));
    type(b.link) = plan_.name(b.link);
    write_struct(plan_.name(b.link), word, words);
  }

  void write_joint(const moving_body& b) {
    const moving_body& in = plan_.parent_of(b);
    const joint& j = plan_.joint_of_body(b);
    declarations_ += "// " + cpp::comment(j.name) + ": from " +
                     cpp::comment(entry(source_.links, in.link).name) + " to " +
                     cpp::comment(entry(source_.links, b.link).name) + "\n";
    if (j.mimic) return write_follower(b);
    const auto [word, axes] = joint_word(j);
    std::vector<std::string> words = placed(type(in.link), b.origin);
    if (!axes.empty()) words.insert(words.begin() + 1, axes);
    write_joint_by(b, word, words, *plan_.joint_by(b.joint));
    if (has_one_coordinate(j.kind)) write_drive(b);
  }

  static std::pair<std::string, std::string> joint_word(const joint& j) {
    if (j.kind == joint_kind::floating) return {"floating", ""};
    if (j.kind == joint_kind::planar) {
      const auto [first, second] = normal_directions(j.axis);
      return {"planar", "axis<" + cpp::list({cpp::along("own", first), cpp::along("own", second)}) + ">"};
    }
    return {j.kind == joint_kind::prismatic ? "prismatic" : "pin", "axis<" + cpp::along("own", j.axis) + ">"};
  }

  void write_drive(const moving_body& b) {
    const joint& j = plan_.joint_of_body(b);
    const std::string& called = plan_.name(b.link);
    const planned_joint& planned = *plan_.joint_by(b.joint);
    loads_.push_back("motor<" + called + ", " + planned.input.called + ">");
    if (plan_.options.damping && j.damping > 0)
      loads_.push_back("joint_friction<" + called + ", " + value("c_" + called, j.damping, damping_of(j)) +
                       ">");
    if (plan_.has_friction(j)) loads_.push_back(friction_of(called, j, called));
    if (plan_.has_stops(j)) loads_.push_back(stop_of(called, j, *plan_.options.stops));
  }

  static kind damping_of(const joint& j) {
    return j.kind == joint_kind::prismatic ? kind::damping : kind::angular_damping;
  }

  static std::string stop_of(const std::string& called, const joint& j, const limit_stops& by) {
    const double stiffness = j.kind == joint_kind::prismatic ? by.sliding : by.turning;
    const double least = (std::max)(j.limits.lower, -by.no_limit),
                 greatest = (std::min)(j.limits.upper, by.no_limit);
    std::vector<std::string> arguments{called};
    for (const double each : {least, greatest, stiffness, by.damping, by.width})
      arguments.push_back(each == 0 ? "0.0" : cpp::number(each)); // the integer 0 is a mistake
    return "stop<" + cpp::list(arguments) + ">";
  }

  /// The dry friction of a joint; `along` is the joint or its coordinate as a pathway.
  std::string friction_of(const std::string& called, const joint& j, const std::string& along) {
    const bool slides = j.kind == joint_kind::prismatic;
    const dry_friction& by = *plan_.options.friction;
    const std::string force = factor("f_" + called, j.friction, slides ? kind::force : kind::torque);
    const std::string slip =
        with_unit(slides ? by.sliding : by.turning, slides ? kind::velocity : kind::angular_velocity);
    return "friction<" + along + ", 1, coulomb_friction<" + force + ", " + slip + ">>";
  }

  /// Writes a mimic joint as a weld whose location depends on the coordinate of its leader.
  void write_follower(const moving_body& b) {
    const joint& j = plan_.joint_of_body(b);
    const std::string &called = plan_.name(b.link), start = called + "_start";
    const motion m = motion_of(b.joint);
    write_weld(start, placed(type(plan_.parent_of(b).link), b.origin));
    const std::string axis = cpp::along(start, j.axis);
    const bool slides = j.kind == joint_kind::prismatic;
    std::vector<std::string> words{start, slides ? "at<" + cpp::factor(m.q) + " * " + cpp::factor(axis) + ">"
                                                 : "home<" + m.q + ", " + axis + ">"};
    if (b.has_mass()) words.push_back(body_of(b));
    type(b.link) = called;
    write_weld(called, words);
    std::string drag;
    if (plan_.options.damping && j.damping > 0)
      drag += "-" + factor("c_" + called, j.damping, damping_of(j)) + " * " + cpp::factor(m.u);
    if (!drag.empty())
      loads_.push_back(std::string(slides ? "force" : "torque") + "_between<" + called + ", " + start + ", " +
                       cpp::factor(drag) + " * " + cpp::factor(axis) + ">");
    if (plan_.has_friction(j)) loads_.push_back(friction_of(called, j, "given_length<" + m.q + ">"));
  }

  void write_weld(const std::string& called, const std::vector<std::string>& words) {
    write_struct(called, "weld", words);
    welds_.push_back(called);
  }

  std::string body_of(const moving_body& b) {
    const std::string& called = plan_.name(b.link);
    const std::string mass = value("m_" + called, b.mass, kind::mass),
                      center = vector("own", called, b.center);
    const inertia_matrix& i = b.inertia;
    const bool is_zero = plan_.binds_numbers() && !(i.largest() > 0);
    std::vector<std::string> scalars{"own"};
    const auto add = [&](const char* prefix, double e) {
      // a model must not contain the integer 0 here, because 1/2 has the same value
      scalars.push_back(is_zero ? "0.0" : value(prefix + called, e, kind::moment_of_inertia));
    };
    add("ixx_", i.xx), add("iyy_", i.yy), add("izz_", i.zz);
    if (!plan_.binds_numbers() || i.xy != 0 || i.yz != 0 || i.zx != 0)
      add("ixy_", i.xy), add("iyz_", i.yz), add("izx_", i.zx);
    std::string inertia = "inertia<" + cpp::list(scalars) + ">";
    if (is_unphysical(i)) inertia = "effective_inertia<" + inertia + ">";
    return "body<" + cpp::list({mass, center, inertia}) + ">";
  }

  /// Writes a rotor, which contributes n² J at the joint and nothing else.
  void write_rotor(const moving_body& b) {
    const joint& j = plan_.joint_of_body(b);
    if (!(j.reflected_inertia() > 0) || !has_one_coordinate(j.kind)) return;
    const std::string &link = plan_.name(b.link), called = link + "_rotor";
    write_struct(called, "rotated", {"N", motion_of(b.joint).q, "N::z"});
    const std::string own = value("j_" + link, j.reflected_inertia(), kind::moment_of_inertia);
    write_struct(called + "_body", "rigid_body",
                 {"N", called, "0", "inertia<" + called + ", 0, 0, " + own + ">"});
    bodies_.push_back(called + "_body");
  }

  /// Writes the links that are fixed to a body, and aliases of the ground.
  void write_fixed_links(const moving_body& b) {
    if (type(b.link) != plan_.name(b.link))
      declarations_ += "using " + plan_.name(b.link) + " = " + type(b.link) + ";\n";
    for (std::size_t l = 0; l < source_.links.size(); ++l) {
      const placed_link& here = plan_.tree.links[l];
      if (&entry(plan_.tree.bodies, here.body) == &b && static_cast<int>(l) != b.link)
        write_weld(plan_.links[l], placed(type(b.link), here.pose_in_body));
    }
  }

  /// Adds gravity as the first load, and the energies of the weightless bodies as the last.
  void write_gravity() {
    const vector3 g = gravity_of(source_, plan_.options);
    const std::string gravity = free_fall(g);
    loads_.insert(loads_.begin(), "gravity<" + gravity + ">");
    if (plan_.binds_numbers() && is_zero(g)) return;
    std::vector<std::string> energies;
    for (const moving_body& b : plan_.tree.bodies)
      if (b.weightless_mass > 0 && !plan_.is_on_ground(b))
        energies.push_back(weight_cancelling_energy(b, plan_.binds_numbers() ? with_units(g) : gravity));
    if (!energies.empty()) // one sum, because the wheels of an axle have equal terms
      loads_.push_back("potential_energy<" + cpp::list(energies, " + ") + ">");
  }

  /// The free-fall acceleration, as an expression.
  std::string free_fall(const vector3& g) {
    const vector3 direction = direction_of_gravity(g);
    const std::string size = value("g", std::hypot(g[0], g[1], g[2]), kind::acceleration);
    if (plan_.binds_numbers() && is_zero(g)) return cpp::along("N", {});
    if (direction == vector3{0, 0, -1}) return "-" + size + " * N::z";
    return plan_.binds_numbers() ? cpp::along("N", g)
                                 : size + " * " + cpp::factor(cpp::along("N", direction));
  }

  /// The free-fall acceleration as a factor.
  std::string with_units(const vector3& g) const {
    std::vector<std::string> terms;
    for (std::size_t i = 0; i < 3; ++i)
      if (g[i] != 0) terms.push_back(with_unit(g[i], kind::acceleration) + " * N::" + "xyz"[i]);
    return cpp::list(terms, " + ");
  }

  /// A potential energy that cancels gravity on a weightless body, so that energy is conserved. A body that
  /// is entirely weightless uses its own symbols.
  std::string weight_cancelling_energy(const moving_body& b, const std::string& gravity) {
    const std::string &on = type(b.link), called = plan_.name(b.link) + "_weightless";
    const std::string symbols = b.is_weightless() ? plan_.name(b.link) : called;
    const auto known = values_.size();
    const std::string mass = factor("m_" + symbols, b.weightless_mass, kind::mass),
                      center = vector(on, symbols, b.weightless_center);
    if (b.is_weightless()) values_.resize(known);
    write_struct(called, "offset", {on, center});
    return mass + " * dot(" + gravity + ", position_of<" + called + ", N>)";
  }

  std::string preamble(const std::string& called, std::string_view from) const {
    constexpr const char* words =
        "about_mass_center at axis bodies body by by_articulated_bodies by_elimination constant coordinate "
        "coulomb_friction dot effective_inertia floating formulation in_absolute_speeds "
        "force_between friction given_length gravity home inertia inertial inertial_ground input inputs "
        "joint_friction joints kane_system loads motor offset own parameter parameter_values parameters pin "
        "planar position_of potential_energy prismatic rigid_body rotated speed state stop torque_between "
        "weld written_in";
    const std::size_t links = source_.links.size(), joints = plan_.tree.joints.size();
    return "#pragma once\n\n" + cpp::include("kanexpr/joints.hpp") + cpp::include("kanexpr/kanexpr.hpp") +
           cpp::include("kanexpr/units/implied.hpp") + "\n" + cpp::include("limits") + "\n/// The robot " +
           cpp::comment(source_.name) + " from " + cpp::comment(from) + ": " + std::to_string(links) +
           (links == 1 ? " link, " : " links, ") + std::to_string(joints) +
           (joints == 1 ? " joint that moves" : " joints that move") + " independently, a " +
           (plan_.has_floating_base() ? "floating" : "fixed") + " base.\n/// Written by kanexpr-robot.\n" +
           names() + cpp::namespace_opening(called, words);
  }

  std::string names() const {
    if (plan_.renamed.empty()) return {};
    std::vector<std::string> all;
    for (const std::string& each : plan_.renamed) all.push_back(cpp::comment(each));
    std::string lines = cpp::wrapped("/// Names in the file: ", all) + ".\n";
    for (std::size_t at = lines.find('\n'); at + 1 < lines.size(); at = lines.find('\n', at + 1))
      lines.replace(at + 1, 3, "///");
    return lines;
  }

  std::string symbols() const {
    std::string lines;
    const auto one = [&](const char* word, const planned_symbol& s) {
      lines +=
          std::string("constexpr ") + word + "<\"" + s.called + "\", " + unit(s.is) + "> " + s.called + ";\n";
    };
    for (const planned_joint& j : plan_.joints) {
      for (const planned_symbol& q : j.coordinates) one("coordinate", q);
      for (const planned_symbol& u : j.speeds) one("speed", u);
      if (!j.input.called.empty()) one("input", j.input);
    }
    for (const auto& [symbol, number] : values_) one("parameter", symbol);
    return lines + "\n";
  }

  std::string system() {
    std::vector<std::string> inputs, p, joints;
    for (const planned_joint& j : plan_.joints) {
      joints.push_back(plan_.name(j.joint < 0 ? source_.root : entry(source_.joints, j.joint).child));
      if (!j.input.called.empty()) inputs.push_back(j.input.called);
    }
    joints.insert(joints.end(), welds_.begin(), welds_.end());
    for (const auto& [symbol, number] : values_) p.push_back(symbol.called);
    std::string lines = "struct System\n    : kane_system<\n          inertial<N>";
    for (const auto& [word, all] : {named_list("joints", joints),
                                    {"parameters", p},
                                    {"inputs", inputs},
                                    {"bodies", bodies_},
                                    {"loads", loads_}})
      if (!all.empty()) lines += ",\n" + cpp::wrapped(std::string(10, ' ') + word + "<", all) + ">";
    if (!plan_.options.formulation.empty()) lines += ",\n" + std::string(10, ' ') + plan_.options.formulation;
    return lines + "> {};\n";
  }

  std::string values() const {
    if (values_.empty()) return {};
    std::string lines =
        "\n/// The values of the parameters in the file.\ninline parameter_values<System> values() {\n"
        "  parameter_values<System> p;\n";
    for (const auto& [symbol, number] : values_)
      lines += "  p[" + symbol.called + "] = " + cpp::number(number) + ";\n";
    return lines + "  return p;\n}\n";
  }

  using named_list = std::pair<const char*, const std::vector<std::string>&>;

  const robot& source_;
  plan plan_;
  std::vector<std::string> types_, loads_{}, welds_{}, bodies_{};
  /// A parameter with its value in the file.
  struct bound_value {
    planned_symbol symbol{};
    double number = 0;
  };
  std::vector<bound_value> values_{};
  std::string declarations_{}, units_ = "units::implied::";
};

} // namespace kanexpr::robots
