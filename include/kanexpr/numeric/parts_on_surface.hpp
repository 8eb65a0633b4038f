#pragma once

#include <cstddef>

namespace kanexpr::numeric {

/// The number of parts into which the line on a surface is divided.
inline constexpr std::size_t parts_on_surface = 12;

} // namespace kanexpr::numeric
