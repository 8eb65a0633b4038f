#pragma once

#include <kanexpr/base/engine.hpp>

#include <string>
#include <string_view>

namespace kanexpr::figures {

/// A name or an expression as the contents of an SVG text element, and its approximate width.
struct text {
  std::string svg{};
  double width = 0; ///< in pixels
};

/// Writes digits after a letter as a subscript, Greek letters by their signs, and a product without its sign.
KANEXPR_ENGINE text typeset(std::string_view plain);

} // namespace kanexpr::figures

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/figures/text.ipp>
#endif
