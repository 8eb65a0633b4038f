#pragma once

#include <kanexpr/animate/check_animation.hpp>
#include <kanexpr/animate/page_text.hpp>
#include <kanexpr/animate/write_page.hpp>
#include <kanexpr/base/outcome.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace kanexpr::animate {

inline constexpr std::string_view motion_placeholder = "@motion@";
inline constexpr std::string_view title_placeholder = "@title@";

/// The contents of the empty page; empty if it cannot be read.
inline std::string read_empty_page(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) return {}; // reading a folder throws
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Escapes a title for use as the text of an element. Control characters, which a page may not contain,
/// become spaces; invalid UTF-8 becomes U+FFFD.
inline std::string escaped_title(const std::string& text) {
  std::string plain;
  for (const char c : valid_utf8(text))
    if (c == '&' || c == '<')
      plain += c == '&' ? "&amp;" : "&lt;";
    else
      plain += is_control(c) ? ' ' : c;
  return plain;
}

/// Fills the placeholders of an empty page. All placeholders are located first, so that the inserted text is
/// not searched for them.
inline outcome fill(std::string& page, const std::string& title, const std::string& motion,
                    const std::string& from) {
  const std::size_t title_at = page.find(title_placeholder), motion_at = page.find(motion_placeholder);
  if (title_at == std::string::npos || motion_at == std::string::npos || motion_at < title_at)
    return outcome(from + " is not an empty page into which a motion can be inserted");
  page.replace(motion_at, motion_placeholder.size(), motion);
  page.replace(title_at, title_placeholder.size(), title);
  return {};
}

/// The reason why a page cannot show an animation; empty if it can.
inline std::string check_motion(const animation& a) {
  if (!a) return a.cause();
  const std::string mistake = check_entries(a);
  return mistake.empty() ? check_numbers(a) : mistake;
}

/// Checks that there are runs, that a page can show all of them, and that their names distinguish them.
inline std::string check_runs(const std::vector<named_animation>& runs) {
  if (runs.empty()) return "a page needs at least one run";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (const std::string mistake = check_motion(runs[i].motion); !mistake.empty())
      return runs.size() == 1 ? mistake : "run " + runs[i].name + ": " + mistake;
    if (runs[i].name.empty() && runs.size() > 1) return "one of several runs has no name";
    for (std::size_t k = 0; k < i; ++k)
      if (runs[i].name == runs[k].name) return "two runs are named " + runs[i].name;
  }
  return {};
}

KANEXPR_PAGES outcome write_page(const std::string& path, const animation& a, const page_options& options) {
  return kanexpr::write_page(path, {{"", a}}, options);
}

} // namespace kanexpr::animate

namespace kanexpr {

KANEXPR_PAGES outcome write_page(const std::string& path, const std::vector<named_animation>& runs,
                                 const page_options& options) {
  if (const std::string mistake = animate::check_runs(runs); !mistake.empty()) return outcome(mistake);
  std::string page = animate::read_empty_page(options.empty_page);
  if (page.empty())
    return outcome("the empty page cannot be read" +
                   (options.empty_page.empty() ? std::string() : ", " + options.empty_page) +
                   "; the target kanexpr_page builds it with npm");
  const animate::mesh_files meshes = animate::read_meshes(runs, options.folder);
  if (!meshes) return outcome(meshes.cause());
  const std::string title = options.title.empty() ? runs.front().motion.system : options.title;
  const std::string motion = animate::page_text(runs, title, options.text, meshes.all);
  outcome filled = animate::fill(page, animate::escaped_title(title), motion, options.empty_page);
  if (!filled) return filled;
  std::ofstream out(path, std::ios::binary);
  out << page;
  out.close();
  if (!out) return outcome(path + " cannot be written");
  return {};
}

} // namespace kanexpr
