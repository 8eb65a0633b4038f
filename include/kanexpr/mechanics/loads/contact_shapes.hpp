#pragma once

namespace kanexpr::mechanics {

/// The shapes that touch in a contact. A point on a plane is a sphere whose radius is zero.
enum class contact_shapes : unsigned char {
  sphere_on_plane,
  torus_on_plane,
  sphere_on_sphere,
  point_on_surface
};

} // namespace kanexpr::mechanics
