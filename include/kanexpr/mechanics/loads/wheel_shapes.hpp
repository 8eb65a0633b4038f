#pragma once

namespace kanexpr::mechanics {

/// The rim of a wheel. A thin wheel is toroidal with a tube whose radius is zero.
enum class rim_shape : unsigned char { toroidal, conical };

/// The ground below a wheel: a plane, a surface z = f(x, y), or the head of a straight rail, which is a
/// circular cylinder.
enum class ground_shape : unsigned char { flat, uneven, rail };

} // namespace kanexpr::mechanics
