#pragma once

#include <kanexpr/animate/animated.hpp>
#include <kanexpr/animate/page_text.hpp>
#include <kanexpr/simulate/outcome.hpp>

#include <fstream>
#include <iterator>

#ifndef KANEXPR_PAGE // where the target kanexpr::animate puts the page without a motion
#define KANEXPR_PAGE ""
#endif

namespace kanexpr {

struct page_options {
  std::string title{};                  ///< the name of the system, unless given
  std::string text{};                   ///< a sentence under the title
  std::string empty_page{KANEXPR_PAGE}; ///< the page without a motion
};

namespace animate {

inline constexpr std::string_view place_of_motion = "@motion@";
inline constexpr std::string_view place_of_title = "@title@";

/// The name of a system in a page.
inline std::string without_markup(std::string_view text) {
  std::string plain;
  for (char c : text) plain += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return plain;
}

inline outcome put(std::string& page, std::string_view place, const std::string& text,
                   const std::string& from) {
  const std::size_t at = page.find(place);
  if (at == std::string::npos) return outcome(from + " is no page for a motion");
  page.replace(at, place.size(), text);
  return {};
}

inline outcome write_page(const std::string& path, const animation& a, const page_options& options) {
  if (!a) return outcome(a.cause());
  std::ifstream file(options.empty_page, std::ios::binary);
  std::string page{std::istreambuf_iterator<char>(file), {}};
  if (page.empty())
    return outcome("the page without a motion is not there" +
                   (options.empty_page.empty() ? std::string() : ", " + options.empty_page) +
                   "; the target kanexpr_page makes it, with npm");
  outcome titled = put(page, place_of_title, without_markup(options.title), options.empty_page);
  if (!titled) return titled;
  outcome filled = put(page, place_of_motion, page_text(a, options.title, options.text), options.empty_page);
  if (!filled) return filled;
  std::ofstream out(path, std::ios::binary);
  out << page;
  out.close();
  if (!out) return outcome(path + " cannot be written");
  return {};
}

} // namespace animate

/// Writes an animated page of a system moving along a trajectory, which a browser opens without a network; or
/// says why it could not.
template <class Picture, class Trajectory>
outcome write_page(const std::string& path, const Trajectory& trajectory, page_options options = {}) {
  if (options.title.empty()) options.title = type_name<typename Picture::System>();
  return animate::write_page(path, animated<Picture>(trajectory), options);
}

} // namespace kanexpr
