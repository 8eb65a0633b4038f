#pragma once

#include <kanexpr/robots/urdf/document.hpp>

#include <string_view>

namespace kanexpr::robots::urdf {

/// Notes the words for Gazebo that change how a robot moves; they are left out as the others are.
inline void note_gazebo(document& from, const element& e) {
  constexpr std::pair<std::string_view, bool> words[]{{"gravity", false},        {"turnGravityOff", true},
                                                      {"kinematic", true},       {"static", true},
                                                      {"springStiffness", true}, {"dampingFactor", true}};
  for (const element* each = e.FirstChildElement(); each; each = each->NextSiblingElement()) {
    const std::string_view is = each->Name();
    std::string_view text = each->GetText() ? each->GetText() : "";
    const std::string_view value = next_word(text);
    const bool is_no = value == "false" || number_in(value) == 0;
    for (const auto& [word, matters] : words)
      if (is == word && !value.empty() && is_no != matters)
        from.note(*each, "<" + shown(is) + ">" + shown(value) + "</" + shown(is) + ">" +
                             (e.Attribute("reference") ? " of " + shown(e.Attribute("reference")) : "") +
                             ", a word for Gazebo, is left out");
  }
}

} // namespace kanexpr::robots::urdf
