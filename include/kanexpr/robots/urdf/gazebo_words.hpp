#pragma once

#include <kanexpr/robots/robot.hpp>
#include <kanexpr/robots/urdf/document.hpp>

#include <algorithm>
#include <string_view>
#include <utility>

namespace kanexpr::robots::urdf {

/// Reads the Gazebo elements that switch off gravity for a link. Other elements that would change the motion
/// of the robot are noted and ignored.
inline void read_gazebo(document& from, const element& e, robot& into) {
  const char* const reference = e.Attribute("reference");
  const auto of_link = std::ranges::find_if(
      into.links, [&](const link& l) { return reference != nullptr && l.name == reference; });
  constexpr std::pair<std::string_view, bool> words[]{{"gravity", false},        {"turnGravityOff", true},
                                                      {"kinematic", true},       {"static", true},
                                                      {"springStiffness", true}, {"dampingFactor", true}};
  for (const element* each = e.FirstChildElement(); each; each = each->NextSiblingElement()) {
    const std::string_view is = each->Name();
    std::string_view text = each->GetText() ? each->GetText() : "";
    const std::string_view value = next_word(text);
    const bool is_no = value == "false" || number_in(value) == 0;
    for (const auto& [word, matters] : words) {
      if (is != word || value.empty() || is_no == matters) continue;
      if ((is == "gravity" || is == "turnGravityOff") && of_link != into.links.end())
        of_link->weightless = true;
      else
        from.note(*each, "<" + shown(is) + ">" + shown(value) + "</" + shown(is) + ">" +
                             (reference != nullptr ? " of " + shown(reference) : "") +
                             ", a Gazebo element, is ignored");
    }
  }
}

} // namespace kanexpr::robots::urdf
