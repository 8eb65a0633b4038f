#pragma once

#include <kanexpr/animate/mesh_files.hpp>
#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/name_of_time.hpp>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <charconv>
#include <string>
#include <string_view>
#include <vector>

/// Converts an animation to the text that the page reads.
namespace kanexpr::animate {

/// Rounds to seven digits; the difference is not visible.
inline double rounded(double value) {
  char digits[32];
  const char* end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 7).ptr;
  double shorter = value;
  std::from_chars(digits, end, shorter);
  return base::equal(shorter, 0.0) ? 0 : shorter; // no −0
}

inline nlohmann::json list_of(const std::vector<double>& values) {
  nlohmann::json all = nlohmann::json::array();
  for (double v : values) all.push_back(rounded(v));
  return all;
}

inline nlohmann::json list_of(const Eigen::Vector3d& v) {
  return list_of(std::vector<double>(v.begin(), v.end()));
}

/// Returns the placements, row by row: 3 numbers for a place, 6 for two ends, and 7 for a pose, whose last
/// four are the quaternion x, y, z, w.
inline std::vector<double> rows_of(const animation::shape& s) {
  std::vector<double> all;
  for (const placement& here : s.placements) {
    all.insert(all.end(), here.position.begin(), here.position.end());
    if (s.placed_by == placing::ends) all.insert(all.end(), here.end.begin(), here.end.end());
    if (s.placed_by != placing::pose) continue;
    const Eigen::Quaterniond turned(here.orientation);
    all.insert(all.end(), {turned.x(), turned.y(), turned.z(), turned.w()});
  }
  return all;
}

inline std::string_view word_for(placing p) {
  switch (p) {
  case placing::place: return "place";
  case placing::ends: return "ends";
  case placing::pose: return "pose";
  }
  return "";
}

inline nlohmann::json shape_text(const animation::shape& s) {
  nlohmann::json one{{"name", s.name},
                     {"kind", s.kind},
                     {"placed", word_for(s.placed_by)},
                     {"opacity", s.opacity},
                     {"sizes", list_of(s.sizes)},
                     {"rows", list_of(rows_of(s))}};
  if (!s.colour.empty()) one["colour"] = s.colour;
  if (!s.file.empty()) one["file"] = s.file;
  return one;
}

inline auto has_column(const animation& a) {
  return [&a](const std::string& name) {
    for (const animation::column& c : a.columns)
      if (c.name == name) return true;
    return false;
  };
}

inline std::string written(const nlohmann::json& all) {
  return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Replaces invalid UTF-8 by U+FFFD.
inline std::string valid_utf8(const std::string& text) {
  return nlohmann::json::parse(written(text)).get<std::string>();
}

inline nlohmann::json file_text(const mesh_file& f) {
  return {{"name", f.name}, {"kind", mesh_kind_of(f.name)}, {"data", f.data}};
}

inline bool is_control(char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }

/// Returns an animation as JSON. It contains no `<`, so that it can be inserted into a page without escaping.
inline std::string page_text(const animation& a, const std::string& title, const std::string& text,
                             const std::vector<mesh_file>& files = {}) {
  nlohmann::json all{{"title", title},
                     {"text", text},
                     {"times", list_of(a.times)},
                     {"nameOfTime", base::name_of_time(has_column(a))},
                     {"up", list_of(a.up)},
                     {"carried", a.carried},
                     {"shapes", nlohmann::json::array()},
                     {"columns", nlohmann::json::array()},
                     {"files", nlohmann::json::array()}};
  if (a.seen_from) all["seenFrom"] = list_of(*a.seen_from);
  if (a.ground) all["ground"] = rounded(*a.ground);
  for (const animation::shape& s : a.shapes) all["shapes"].push_back(shape_text(s));
  for (const animation::column& c : a.columns)
    all["columns"].push_back({{"name", c.name}, {"values", list_of(c.values)}});
  for (const mesh_file& f : files) all["files"].push_back(file_text(f));
  std::string page = written(all);
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at))
    page.replace(at, 1, "\\u003c");
  return page;
}

} // namespace kanexpr::animate
