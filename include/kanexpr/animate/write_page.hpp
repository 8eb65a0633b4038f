#pragma once

#include <kanexpr/animate/animated.hpp>
#include <kanexpr/animate/page_options.hpp>

#ifndef KANEXPR_COMPILED_PAGES
#include <kanexpr/animate/page_file.hpp>
#include <kanexpr/base/outcome.hpp>

#include <string>
#endif

namespace kanexpr {

/// Writes an animated page of a system moving along a trajectory, which a browser opens without network
/// access, or reports why it cannot.
template <class Picture, class Trajectory>
outcome write_page(const std::string& path, const Trajectory& trajectory, page_options options = {}) {
  if (options.title.empty()) options.title = type_name<typename Picture::System>();
  return animate::write_page(path, animated<Picture>(trajectory), options);
}

} // namespace kanexpr
