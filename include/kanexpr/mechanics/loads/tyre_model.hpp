#pragma once

namespace kanexpr::mechanics {

/// The laws of tyres (tyre_law.hpp).
enum class tyre_model : unsigned char { linear, brush, magic_formula };

} // namespace kanexpr::mechanics
