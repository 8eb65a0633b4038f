#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/robots/pose.hpp>
#include <kanexpr/robots/robot.hpp>

#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

/// Reads numbers in the text of a file, independently of the locale.
namespace kanexpr::robots::urdf {

inline constexpr std::string_view spaces = " \t\r\n\f\v";

/// Removes the next word from a text and returns it; empty at the end of the text.
inline std::string_view next_word(std::string_view& text) {
  const std::size_t from = text.find_first_not_of(spaces);
  if (from == std::string_view::npos) return text = {};
  text.remove_prefix(from);
  const std::string_view word = text.substr(0, text.find_first_of(spaces));
  text.remove_prefix(word.size());
  return word;
}

/// The value of a word if the whole word is a finite number. Numbers that underflow are 0.
inline std::optional<double> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  if (word.empty() || word.starts_with('+')) return {};
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return {};
  if (error == std::errc::result_out_of_range)
    return word.find("e-") == word.npos && word.find("E-") == word.npos ? std::nullopt : std::optional(0.0);
  if (error != std::errc() || !numeric::is_finite(value)) return {};
  return value;
}

using element = tinyxml2::XMLElement;

/// Returns the child elements with the given name, or all if no name is given.
inline std::vector<const element*> children(const element& in, const char* name = nullptr) {
  std::vector<const element*> all;
  for (const element* e = in.FirstChildElement(name); e; e = e->NextSiblingElement(name)) all.push_back(e);
  return all;
}

/// A file that is being read: its elements, the numbers in them, and the first mistake.
class document {
public:
  document(std::string called, double right_angles) : called_(std::move(called)), tolerance_(right_angles) {}

  /// The root element; null after a mistake.
  const element* open(const std::string& text) {
    if (text.find('\0') != std::string::npos)
      return fail("the file contains a zero byte, so it is not XML"), nullptr;
    if (xml_.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
      return fail(xml_.ErrorLineNum(), cause_of(xml_.ErrorID())), nullptr;
    for (const tinyxml2::XMLNode* n = xml_.FirstChild(); n; n = n->NextSibling())
      if (n->ToUnknown() && std::string_view(n->Value()).find_first_of("[&%") != std::string_view::npos)
        return fail(n->GetLineNum(), "the document type declares entities, which are not expanded"), nullptr;
    return xml_.RootElement();
  }

  const std::string& mistake() const { return mistake_; }
  double tolerance() const { return tolerance_; }
  /// Notes about elements and values that were ignored or not used as written.
  const std::vector<std::string>& notes() const { return notes_; }
  std::vector<std::string>&& take_notes() { return std::move(notes_); }

  bool fail(int line, const std::string& what) {
    if (mistake_.empty()) mistake_ = at(line) + what;
    return false;
  }
  bool fail(const element& e, const std::string& what) { return fail(e.GetLineNum(), what); }
  /// Reports a mistake that concerns the whole file.
  bool fail(const std::string& what) {
    if (mistake_.empty()) mistake_ = called_.empty() ? what : called_ + ": " + what;
    return false;
  }
  void note(int line, const std::string& what) {
    if (notes_.size() < max_notes)
      notes_.push_back(at(line) + what);
    else if (notes_.size() == max_notes)
      notes_.push_back("further notes are not listed");
  }
  void note(const element& e, const std::string& what) { note(e.GetLineNum(), what); }

  /// The value of a required attribute.
  std::optional<std::string> text(const element& e, const char* attribute, const std::string& whose) {
    if (const char* found = e.Attribute(attribute); found && *found) return std::string(found);
    fail(e, whose + " has no " + attribute);
    return {};
  }

  /// Reads an attribute into a number, which is left unchanged if the attribute is missing.
  bool read(const element& e, const char* attribute, double& into, const std::string& whose) {
    const char* const found = e.Attribute(attribute);
    return !found || read_numbers(e, attribute, found, &into, 1, whose);
  }
  bool read(const element& e, const char* attribute, vector3& into, const std::string& whose) {
    const char* const found = e.Attribute(attribute);
    return !found || read_numbers(e, attribute, found, into.data(), 3, whose);
  }
  /// Returns the child element with the given name; notes a second one.
  const element* single_child(const element& in, const char* name, const std::string& whose) {
    const element* const first = in.FirstChildElement(name);
    if (const element* const second = first ? first->NextSiblingElement(name) : nullptr)
      note(*second, whose + " has a second <" + name + ">, which is ignored");
    return first;
  }
  /// Notes the unknown attributes of an element.
  void note_unknown_attributes(const element& e, std::initializer_list<std::string_view> known,
                               const std::string& whose) {
    for (const tinyxml2::XMLAttribute* a = e.FirstAttribute(); a; a = a->Next())
      if (std::ranges::find(known, a->Name()) == known.end())
        note(e, whose + " has the unknown attribute " + printable(a->Name()) + ", which is ignored");
  }
  /// Notes the unknown child elements of an element.
  void note_unknown_elements(const element& in, std::initializer_list<std::string_view> known,
                             const std::string& whose) {
    for (const element* e : children(in))
      if (std::ranges::find(known, e->Name()) == known.end())
        note(*e, whose + " contains the unknown element <" + printable(e->Name()) + ">, which is ignored");
  }

  /// Reads the <origin> of an element.
  bool read_origin(const element& in, pose& into, const std::string& whose) {
    const element* const origin = single_child(in, "origin", whose);
    if (!origin) return true;
    const std::string of = "the origin of " + whose;
    note_unknown_attributes(*origin, {"xyz", "rpy", "quat_xyzw"}, of);
    return read(*origin, "xyz", into.position, of) &&
           (origin->Attribute("quat_xyzw") ? read_quaternion(*origin, into.orientation, of)
                                           : read_angles(*origin, into.orientation, of));
  }

private:
  std::string at(int line) const {
    return "line " + std::to_string((std::max)(line, 1)) + (called_.empty() ? "" : " of " + called_) + ": ";
  }
  static std::string cause_of(tinyxml2::XMLError error) {
    if (error == tinyxml2::XML_ERROR_EMPTY_DOCUMENT)
      return "there is no element, so the file does not describe a robot";
    if (error == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) return "elements are nested too deeply";
    if (error == tinyxml2::XML_ERROR_MISMATCHED_ELEMENT) return "an element is not closed properly";
    return "this is not valid XML";
  }

  static const char* advice_on(std::string_view word) {
    if (word.find('$') != word.npos) return "; this may be a xacro file: run xacro on it first";
    return word.find(',') == word.npos ? "" : "; use a decimal point";
  }

  bool read_angles(const element& e, rotation& into, const std::string& of) {
    constexpr double turn = 2 * std::numbers::pi + 1e-3;
    vector3 angles{};
    if (!read(e, "rpy", angles, of)) return false;
    if (std::ranges::any_of(angles, [&](double a) { return std::abs(a) > turn; }))
      note(e, "rpy=\"" + printable(e.Attribute("rpy")) + "\" of " + of +
                  " exceeds a full turn; angles are read in radians");
    into = rotation_by_rpy(angles, tolerance_);
    return true;
  }
  bool read_quaternion(const element& e, rotation& into, const std::string& of) {
    if (e.Attribute("rpy")) return fail(e, of + " has both rpy and quat_xyzw");
    double q[4]{};
    if (!read_numbers(e, "quat_xyzw", e.Attribute("quat_xyzw"), q, 4, of)) return false;
    const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(std::abs(norm - 1) < 1e-2))
      return fail(e, "quat_xyzw=\"" + printable(e.Attribute("quat_xyzw")) + "\" of " + of +
                         " does not have norm 1");
    for (double& each : q) each /= norm;
    into = round_right_angles(rotation_by_quaternion(q[0], q[1], q[2], q[3]), tolerance_);
    return true;
  }

  bool read_numbers(const element& e, const char* attribute, std::string_view words, double* into, int count,
                    const std::string& whose) {
    const std::string what = std::string(attribute) + "=\"" + printable(words) + "\" of " + whose;
    for (int i = 0; i < count; ++i) {
      const std::string_view word = next_word(words);
      if (word.empty())
        return fail(e, what + " has too few numbers: " + std::to_string(i) + " of " + std::to_string(count));
      const std::optional<double> value = number_in(word);
      if (!value)
        return fail(e, what + " contains " + printable(word) + ", which is not a finite number" +
                           advice_on(word));
      into[i] = *value;
    }
    return next_word(words).empty() ||
           fail(e, what + " has more than " + std::to_string(count) + (count == 1 ? " number" : " numbers"));
  }

  static constexpr std::size_t max_notes = 100;

  tinyxml2::XMLDocument xml_{};
  std::string called_, mistake_{};
  std::vector<std::string> notes_{};
  double tolerance_;
};

} // namespace kanexpr::robots::urdf
