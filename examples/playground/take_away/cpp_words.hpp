#pragma once

#include "playground/take_away/in_cpp.hpp"
#include "playground/take_away/structs.hpp"
#include "playground/text/line.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace playground {

/// A model in the words of kanexpr: a struct for each frame, point and body, and a system that lists them.
class cpp_words {
public:
  cpp_words(const std::vector<line>& lines, std::string inertial_frame)
      : lines_(lines), inertial_(std::move(inertial_frame)) {
    add_struct(inertial_, "inertial_frame", inertial_);
    for (const line& l : lines_) take(l);
  }

  /// The header, in a namespace; `values` are appended to the words.
  std::string header(const std::string& name, const std::string& values) const {
    std::string text = "#pragma once\n\n#include <kanexpr/kanexpr.hpp>\n\nnamespace " + name +
                       " {\n\nusing namespace kanexpr;\n\n" + symbols_;
    if (uses_time_) text += "constexpr time_variable t;\n";
    text += '\n' + structs_.text() + '\n' + system() + values;
    return text + "\n} // namespace " + name + '\n';
  }

  /// Why there are no types: structs that contain each other.
  std::string mistake() const { return structs_.mistake(); }

private:
  using list = std::vector<std::string>;

  void take(const line& l) {
    note_time(l);
    if (take_symbol(l) || take_frame(l) || take_point(l) || take_body(l) || take_load(l)) return;
    take_equation(l);
  }

  bool take_symbol(const line& l) {
    if (l.word != "parameter" && l.word != "input" && l.word != "coordinate" && l.word != "speed")
      return false;
    declare(l.word, l.name(0));
    return true;
  }
  void declare(const std::string& kind, const std::string& name) {
    symbols_ += "constexpr " + kind + "<\"" + name + "\"> " + name + ";\n";
    lists_[kind == "coordinate" ? "coordinates" : kind + 's'].push_back(name);
  }

  bool take_frame(const line& l) {
    const auto moves = [&](const std::string& frame) { // its declared angular velocity
      for (const line& other : lines_)
        if (other.word == "angular_velocity" && other.name(0) == frame)
          return ", angular_velocity<" + other.name(1) + ", " + cpp_expression(frame)(other.expression(2)) +
                 '>';
      return std::string();
    };
    const auto add = [&](const list& of) {
      add_struct(l.name(0), l.word == "pin" ? "rotated" : l.word, joined(of), moves(l.name(0)));
    };
    if (l.word == "pin") {
      declare_joint(l);
      add({l.name(0), l.name(1), l.name(3), in_words(l.expression(2))});
    } else if (l.word == "rotated") {
      add({l.name(0), l.name(1), in_words(l.expression(2)), in_words(l.expression(3))});
    } else if (l.word == "body_fixed" || l.word == "space_fixed") {
      add({l.name(0), l.name(1), '"' + l.name(2) + '"', in_words(l.list(3))});
    } else if (l.word == "kinematics_of") {
      lists_["kinematics"].push_back("kinematics_of<" + l.name(0) + ", " + l.name(1) + '>');
    } else {
      return l.word == "angular_velocity";
    }
    return true;
  }

  bool take_point(const line& l) {
    const auto moves = [&](const std::string& point) {
      for (const line& other : lines_)
        if (other.word == "fixed" && other.name(0) == point) return ", fixed_in<" + other.name(1) + '>';
      return std::string();
    };
    if (l.word == "slider") {
      declare_joint(l);
      const tree along{.is = tree::kind::product,
                       .parts = {{.is = tree::kind::name, .text = l.name(3)}, l.expression(2)}};
      add_struct(l.name(0), "offset", joined({l.name(0), l.name(1), in_words(along)}), moves(l.name(0)));
    } else if (l.word == "origin") {
      add_struct(l.name(0), "origin", joined({l.name(0), inertial_}));
    } else if (l.word == "offset") {
      add_struct(l.name(0), "offset", joined({l.name(0), l.name(1), in_words(l.expression(2))}),
                 moves(l.name(0)));
    } else {
      return l.word == "fixed";
    }
    return true;
  }

  /// A pin or a slider declares a coordinate and its rate.
  void declare_joint(const line& l) {
    declare("coordinate", l.name(3));
    declare("speed", l.name(5));
    lists_["kinematics"].push_back("dot(" + l.name(3) + ") == " + l.name(5));
  }

  bool take_body(const line& l) {
    if (l.word == "particle") {
      add_struct(l.name(0), "particle", joined({l.name(0), l.name(1), in_words(l.expression(2))}));
    } else if (l.word == "rigid_body") {
      const std::string axes = l.has(5) ? l.name(5) : l.name(2);
      add_struct(l.name(0), "rigid_body",
                 joined({l.name(0), l.name(1), l.name(2), in_words(l.expression(3)),
                         "inertia<" + axes + ", " + in_words(l.list(4)) + '>'}));
    } else {
      return false;
    }
    lists_["bodies"].push_back(l.name(0));
    return true;
  }

  bool take_load(const line& l) {
    if (l.word == "gravity" || l.word == "potential_energy") {
      add_load(l, {in_words(l.expression(0))});
    } else if (l.word == "force" || l.word == "torque") {
      add_load(l, {l.name(1), in_words(l.expression(0))});
    } else if (l.word == "force_between" || l.word == "torque_between") {
      add_load(l, {l.name(1), l.name(2), in_words(l.expression(0))});
    } else if (l.word == "spring" || l.word == "damper" || l.word == "torsional_damper") {
      list of{l.name(0), l.name(1), in_words(l.expression(2))};
      if (l.word == "spring" && l.has(3)) of.push_back(in_words(l.expression(3)));
      add_load(l, of);
    } else if (l.word == "torsional_spring") {
      list of{in_words(l.expression(0)), in_words(l.expression(1))};
      if (l.has(2)) of.push_back(in_words(l.expression(2)));
      add_load(l, of);
    } else {
      return false;
    }
    return true;
  }
  void add_load(const line& l, const list& of) { lists_["loads"].push_back(l.word + '<' + joined(of) + '>'); }

  void take_equation(const line& l) {
    const auto equation = [&] { return in_words(l.expression(0)) + " == " + in_words(l.expression(1)); };
    if (l.word == "kinematics") lists_["kinematics"].push_back(equation());
    if (l.word == "configuration_constraint" || l.word == "velocity_constraint")
      lists_[l.word + 's'].push_back(equation());
    if (l.word == "loop")
      lists_["configuration_constraints"].push_back("zero_along<position_of<" + l.name(0) + ", " + l.name(1) +
                                                    ">, " + in_words(l.list(2)) + '>');
    if (l.word == "no_slip")
      lists_["velocity_constraints"].push_back("zero_along<velocity_of<" + l.name(0) + ">, " +
                                               in_words(l.list(1)) + '>');
    if (l.word == "dependent")
      for (const tree& each : l.list(0)) lists_["dependent"].push_back(in_words(each));
  }

  std::string system() const {
    std::string text = "struct System\n    : kane_system<inertial<" + inertial_ + '>';
    for (const std::string called :
         {"coordinates", "speeds", "kinematics", "configuration_constraints", "velocity_constraints",
          "dependent", "parameters", "inputs", "bodies", "loads"})
      if (const auto found = lists_.find(called); found != lists_.end())
        text += ",\n" + std::string(indentation, ' ') + called + '<' +
                wrapped(found->second, indentation + called.size() + 1) + '>';
    return text + "> {};\n";
  }

  static constexpr std::size_t indentation = 18, widest = 110;

  /// A list with commas, in lines that begin in the same column.
  static std::string wrapped(const list& all, std::size_t column) {
    std::string text;
    std::size_t width = column;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i > 0 && width + all[i].size() > widest) {
        text += ",\n" + std::string(column, ' ');
        width = column;
      } else if (i > 0) {
        text += ", ";
      }
      text += all[i];
      width += all[i].size() + 2;
    }
    return text;
  }

  void add_struct(const std::string& name, const std::string& word, const std::string& arguments,
                  const std::string& more = "") {
    structs_.add(name, word + '<' + arguments + '>' + more);
  }

  void note_time(const line& l) {
    for (const line::slot& each : l.slots)
      for (const tree& e : each.written) note_time(e);
  }
  void note_time(const tree& e) {
    if (e.is == tree::kind::name && e.text == "t" && !declares("t")) uses_time_ = true;
    for (const tree& each : e.parts) note_time(each);
  }
  bool declares(const std::string& name) const {
    for (const line& l : lines_)
      for (const line::slot& each : l.slots)
        if (each.name == name) return true;
    return false;
  }

  static std::string in_words(const tree& e) { return cpp_expression()(e); }
  static std::string in_words(const std::vector<tree>& all) {
    list each;
    for (const tree& e : all) each.push_back(in_words(e));
    return joined(each);
  }
  static std::string joined(const list& all) {
    std::string text;
    for (std::size_t i = 0; i < all.size(); ++i) text += (i == 0 ? "" : ", ") + all[i];
    return text;
  }

  const std::vector<line>& lines_;
  std::string inertial_;
  std::string symbols_{};
  structs structs_{};
  std::map<std::string, list> lists_{};
  bool uses_time_ = false;
};

} // namespace playground
