#pragma once

#include "playground/model/build_bodies.hpp"
#include "playground/model/build_constraints.hpp"
#include "playground/model/build_joints.hpp"
#include "playground/model/build_loads.hpp"
#include "playground/model/build_symbols.hpp"
#include "playground/text/read_lines.hpp"

#include <cctype>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace playground {

/// A word and the calls to the builder that its lines make. Geometry comes first, so that loads and
/// constraints may contain the velocities of any point.
struct builder_call {
  std::string_view word{};
  void (*make)(construction&, const line&) = nullptr;
  bool is_geometry = true;
};

inline void build_one_symbol(construction& in, const line& l) { build_symbol(in, l, 0, l.word); }
inline void build_origin(construction& in, const line& l) { in.declare(l.name(0), in.b.origin(l.name(0))); }

inline constexpr builder_call builder_calls[]{
    {"parameter", build_one_symbol},
    {"input", build_one_symbol},
    {"coordinate", build_one_symbol},
    {"speed", build_one_symbol},
    {"kinematics", build_kinematics},
    {"pin", build_joint},
    {"slider", build_joint},
    {"rotated", build_rotated},
    {"body_fixed", build_rotated_by_sequence},
    {"space_fixed", build_rotated_by_sequence},
    {"angular_velocity", build_angular_velocity},
    {"kinematics_of", build_kinematics_of},
    {"origin", build_origin},
    {"offset", build_offset},
    {"fixed", build_fixed},
    {"particle", build_particle},
    {"rigid_body", build_rigid_body},
    {"gravity", build_gravity, false},
    {"force", build_force, false},
    {"force_between", build_force, false},
    {"torque", build_torque, false},
    {"torque_between", build_torque, false},
    {"spring", build_spring, false},
    {"damper", build_damper, false},
    {"torsional_spring", build_torsional_spring, false},
    {"torsional_damper", build_torsional_damper, false},
    {"potential_energy", build_potential_energy, false},
    {"loop", build_loop, false},
    {"no_slip", build_no_slip, false},
    {"configuration_constraint", build_equation, false},
    {"velocity_constraint", build_equation, false},
    {"dependent", build_dependent, false},
};

/// A model read from a text, or its first mistake.
struct built_model {
  std::vector<line> lines{};
  std::unique_ptr<construction> made{};
  mistake wrong{};
};

/// The line that declares the last thing that a sentence names; 0 if it names none.
inline int line_named_in(const std::string& sentence, const std::vector<line>& lines) {
  int found = 0;
  std::string word;
  for (const char c : sentence + ' ') {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
      continue;
    }
    for (const line& l : lines)
      for (const line::slot& each : l.slots)
        if (!word.empty() && each.name == word && each.written.empty()) {
          found = l.number;
          break;
        }
    word.clear();
  }
  return found;
}

inline std::string inertial_frame_of(const std::vector<line>& lines) {
  for (const line& l : lines)
    if (l.word == "inertial") return l.name(0);
  return "N";
}

inline void build_lines(built_model& all, bool geometry) {
  for (const line& l : all.lines)
    for (const builder_call& call : builder_calls) {
      if (call.word != l.word || call.is_geometry != geometry) continue;
      call.make(*all.made, l);
      if (const std::string wrong = all.made->wrong(); !wrong.empty()) {
        all.wrong = {l.number, wrong};
        return;
      }
    }
}

/// Builds the model that a text describes.
inline built_model build(std::string_view text) {
  read_text read = read_lines(text);
  built_model all{.lines = std::move(read.lines), .wrong = std::move(read.wrong)};
  if (!all.wrong.sentence.empty()) return all;
  all.made = std::make_unique<construction>(inertial_frame_of(all.lines));
  build_lines(all, true);
  all.made->allow_velocities();
  if (all.wrong.sentence.empty()) build_lines(all, false);
  if (!all.wrong.sentence.empty()) return all;
  const auto found = (all.made->b.check)();
  if (found) all.wrong = {line_named_in(std::string(found.view()), all.lines), std::string(found.view())};
  return all;
}

} // namespace playground
