#pragma once

#include <kanexpr/animate/page_text.hpp>
#include <kanexpr/animate/write_page.hpp>
#include <kanexpr/base/outcome.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace kanexpr::animate {

inline constexpr std::string_view motion_placeholder = "@motion@";
inline constexpr std::string_view title_placeholder = "@title@";

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

KANEXPR_PAGES outcome write_page(const std::string& path, const animation& a, const page_options& options) {
  if (!a) return outcome(a.cause());
  std::ifstream file(options.empty_page, std::ios::binary);
  std::string page{std::istreambuf_iterator<char>(file), {}};
  if (page.empty())
    return outcome("the empty page cannot be read" +
                   (options.empty_page.empty() ? std::string() : ", " + options.empty_page) +
                   "; the target kanexpr_page builds it with npm");
  const mesh_files meshes = read_meshes(a, options.folder.empty() ? a.folder : options.folder);
  if (!meshes) return outcome(meshes.cause());
  const std::string motion = page_text(a, options.title, options.text, meshes.all);
  outcome filled = fill(page, escaped_title(options.title), motion, options.empty_page);
  if (!filled) return filled;
  std::ofstream out(path, std::ios::binary);
  out << page;
  out.close();
  if (!out) return outcome(path + " cannot be written");
  return {};
}

} // namespace kanexpr::animate
