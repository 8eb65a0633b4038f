#pragma once

namespace kanexpr::mechanics {

/// The laws of friction (friction_law.hpp). `bristles` are those of Dahl and LuGre.
enum class friction_kind : unsigned char { frictionless, coulomb, stribeck, viscous, bristles };

} // namespace kanexpr::mechanics
