#pragma once

namespace kanexpr::mechanics {

/// The laws of friction (friction_law.hpp).
enum class friction_kind : unsigned char { frictionless, coulomb, stribeck, viscous };

} // namespace kanexpr::mechanics
