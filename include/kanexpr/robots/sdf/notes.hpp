#pragma once

#include <kanexpr/robots/urdf/document.hpp>

#include <sdf/Console.hh>
#include <sdf/Element.hh>
#include <sdf/Param.hh>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace kanexpr::robots::sdf {

/// Captures the messages that libsdformat would print. (libsdformat passes text that is not SDF to urdfdom,
/// which still prints a line.)
class messages {
public:
  messages() : stream_(::sdf::Console::Instance()->GetMsgStream()), to_(stream_.GetStream()) {
    stream_.SetStream(&kept_);
  }
  ~messages() { stream_.SetStream(to_); }
  messages(const messages&) = delete;
  messages& operator=(const messages&) = delete;

  /// Notes the elements and attributes that libsdformat does not know, except those of mimics, which are read
  /// elsewhere.
  void note_in(urdf::document& from) const {
    std::istringstream all(kept_.str());
    for (std::string line; std::getline(all, line);) {
      const std::size_t is = line.find(" XML "), end = line.find(" not defined in SDF");
      if (is == line.npos || end == line.npos || line.find("Element[mimic]") != line.npos) continue;
      const std::size_t place = line.rfind(":L", is);
      const auto number = urdf::number_in(
          place == line.npos ? "" : line.substr(place + 2, line.find(']', place) - place - 2));
      from.note(static_cast<int>(number.value_or(1)),
                "libsdformat reports: " + printable(line.substr(is + 1, end - is - 1), 200) +
                    " not defined in SDF; it is ignored");
    }
  }

private:
  std::ostringstream kept_{};
  ::sdf::Console::ConsoleStream& stream_;
  std::ostream* to_;
};

/// Notes the elements of a file that affect the motion but are not supported, and angles that may be in
/// degrees.
class unsupported_elements {
public:
  explicit unsupported_elements(urdf::document& from) : from_(from) {}

  /// Checks an element and its descendants.
  void note_in(const ::sdf::ElementPtr& e) {
    if (e->GetExplicitlySetInFile()) note(*e);
    note_second_ones(*e);
    for (::sdf::ElementPtr each = e->GetFirstElement(); each; each = each->GetNextElement()) note_in(each);
  }

private:
  void note(::sdf::Element& e) {
    if (e.GetName() == "plugin") return say(e, "plugin " + printable(name_of(e)) + " is ignored");
    if (!e.GetValue()) return;
    const std::string text = e.GetValue()->GetAsString();
    const std::string what =
        "<" + e.GetName() + ">" + printable(text) + "</" + e.GetName() + "> of " + owner_of(e);
    if (e.GetName() == "pose") {
      if (!is_in_degrees(e) && is_more_than_a_turn(text))
        say(e, what + " exceeds a full turn; angles are read in radians");
    } else if (changes_motion(e) && !is_nothing(text)) {
      say(e, what + " is ignored");
    }
  }
  /// Notes repeated elements that are expected only once; only the first one is read.
  void note_second_ones(::sdf::Element& in) {
    constexpr std::string_view once[]{"pose",  "inertial", "mass",  "inertia", "gravity",  "static", "parent",
                                      "child", "axis",     "axis2", "xyz",     "dynamics", "damping"};
    std::set<std::string> seen;
    for (::sdf::ElementPtr e = in.GetFirstElement(); e; e = e->GetNextElement())
      if (std::ranges::find(once, e->GetName()) != std::end(once) && !seen.insert(e->GetName()).second)
        say(*e, called(in) + " has a second <" + e->GetName() + ">, which is ignored");
  }
  void say(::sdf::Element& e, const std::string& what) { from_.note(e.LineNumber().value_or(1), what); }

  static std::string name_of(::sdf::Element& e) {
    return e.HasAttribute("name") ? e.GetAttribute("name")->GetAsString() : "";
  }
  static std::string called(::sdf::Element& e) {
    const std::string name = name_of(e);
    return e.GetName() + (name.empty() ? "" : " " + printable(name));
  }
  static std::string owner_of(::sdf::Element& e) {
    const ::sdf::ElementPtr in = e.GetParent();
    return in ? called(*in) : "";
  }

  static bool changes_motion(::sdf::Element& e) {
    constexpr std::pair<std::string_view, std::string_view> words[]{{"link", "kinematic"},
                                                                    {"velocity_decay", "linear"},
                                                                    {"velocity_decay", "angular"},
                                                                    {"wind", "linear_velocity"}};
    const ::sdf::ElementPtr in = e.GetParent();
    return in && std::ranges::find(words, std::pair<std::string_view, std::string_view>(
                                              in->GetName(), e.GetName())) != std::end(words);
  }
  static bool is_nothing(std::string_view text) {
    for (std::string_view word = urdf::next_word(text); !word.empty(); word = urdf::next_word(text))
      if (word != "false" && urdf::number_in(word) != 0.0) return false;
    return true;
  }

  static bool is_in_degrees(::sdf::Element& e) {
    return e.HasAttribute("degrees") && e.Get<bool>("degrees", false).first;
  }
  static bool is_more_than_a_turn(std::string_view pose) {
    constexpr double turn = 2 * std::numbers::pi + 1e-3;
    for (int i = 0; i < 3; ++i) urdf::next_word(pose);
    for (std::string_view word = urdf::next_word(pose); !word.empty(); word = urdf::next_word(pose))
      if (std::abs(urdf::number_in(word).value_or(0)) > turn) return true;
    return false;
  }

  urdf::document& from_;
};

} // namespace kanexpr::robots::sdf
