#pragma once

#include <kanexpr/describe/symbol.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr {

/// The coordinates of a point near a surface, in the function that describes the surface.
struct surface {
  static constexpr scalar<1> x =
      describe::symbol_token<symbolic::symbol_kind::direction, "surface::x", unnumbered>();
  static constexpr scalar<1> y =
      describe::symbol_token<symbolic::symbol_kind::direction, "surface::y", unnumbered>();
  static constexpr scalar<1> z =
      describe::symbol_token<symbolic::symbol_kind::direction, "surface::z", unnumbered>();
};

} // namespace kanexpr
