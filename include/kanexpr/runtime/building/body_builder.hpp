#pragma once

#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

/// The particles, rigid bodies and rotors of a builder.
class body_builder : private builder_part {
public:
  void particle(std::string_view called, point_id at, expression mass);
  void rigid_body(std::string_view called, point_id center, frame_id frame, expression mass,
                  const dyadic& inertia) {
    rigid_body(called, center, frame, mass, inertia, center);
  }
  /// A rigid body with its inertia about any point of the body.
  void rigid_body(std::string_view called, point_id center, frame_id frame, expression mass,
                  const dyadic& inertia, point_id about);
  /// Declares that the inertia of a rigid body intentionally varies in body-fixed axes.
  void changing_inertia(std::string_view body);
  /// Declares that the inertia of a body is intentionally not that of a mass distribution.
  void effective_inertia(std::string_view body);
  /// A rotor that turns `gear_ratio` times as fast as an angle, such as the coordinate of a joint, with the
  /// energy ½ J (n dq/dt)², as `rotor<J, n>` of a joint. The inertia and the ratio are constants. Requires a
  /// point.
  void rotor(std::string_view called, expression angle, const number_or_expression& inertia,
             const number_or_expression& gear_ratio = 1.0);

protected:
  explicit body_builder(builder_core& core) : builder_part(core) {}
  ~body_builder() = default;

private:
  void mark_body(std::string_view body, bool mechanics::body::* mark, std::string_view whose);
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/body_builder.ipp>
#endif
