#pragma once

#include <kanexpr/animate/animated.hpp>
#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/compiled_pages.hpp>
#include <kanexpr/base/outcome.hpp>

#include <string>
#include <vector>

#ifndef KANEXPR_PAGE // path of the empty page, set by the target kanexpr::animate
#define KANEXPR_PAGE ""
#endif

namespace kanexpr {

/// Options of `write_page`.
struct page_options {
  std::string title{};                  ///< default: the name of the system
  std::string text{};                   ///< text below the title
  std::string empty_page{KANEXPR_PAGE}; ///< path of the empty page, without a motion
  std::string folder{}; ///< folder for relative file names; if empty, the folder that the picture specifies
};

/// Writes a page that shows several runs together, of the same picture or of different ones:
///
///     write_page("runs.html", {{"pushed", animated<swing>(first)}, {"free", animated<swing>(second)}});
///
/// The first run determines the view. Reports the reason if the page cannot be written.
KANEXPR_PAGES outcome write_page(const std::string& path, const std::vector<named_animation>& runs,
                                 const page_options& options = {});

namespace animate {

/// Writes an animation to a page.
KANEXPR_PAGES outcome write_page(const std::string& path, const animation& a, const page_options& options);

} // namespace animate

/// Writes an animated page of a system that moves along a trajectory; a browser opens the page without
/// network access. Reports the reason if the page cannot be written.
template <class Picture, class Trajectory>
outcome write_page(const std::string& path, const Trajectory& trajectory, const page_options& options = {}) {
  return animate::write_page(path, animated<Picture>(trajectory), options);
}

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_PAGES
#include <kanexpr/animate/write_page.ipp>
#endif
