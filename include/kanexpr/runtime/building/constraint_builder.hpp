#pragma once

#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/runtime/building/point_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <concepts>
#include <string_view>
#include <vector>

namespace kanexpr::runtime {

/// A vector whose components along `directions` vanish.
struct zero_components {
  vector value;
  std::vector<vector> directions;
};

/// The constraints of a builder. Their expressions may contain velocities of a `mechanics::known_motion`.
class constraint_builder : private builder_part {
public:
  /// A vector whose components along the given directions vanish, with one constraint per direction:
  /// `b.configuration_constraint(b.zero_along(b.position_of(P, Q), b.along(N, 1, 0, 0), b.along(N, 0, 1,
  /// 0)))`.
  template <std::same_as<vector>... Directions>
  static zero_components zero_along(const vector& v, const Directions&... directions) {
    return {v, {directions...}};
  }

  /// Makes two points coincide along directions, which closes a loop:
  /// `b.configuration_constraint(b.coincident(P, Q, x, y))`.
  template <std::same_as<vector>... Directions>
  zero_components coincident(point_id point, point_id other, const Directions&... directions) {
    return zero_along(points_.position_of(point, other), directions...);
  }
  /// Keeps a direction parallel to an axis of a frame, numbered from 0; together with `coincident`, it closes
  /// a loop with a pin about this axis.
  zero_components parallel(const vector& direction, frame_id frame, int axis);
  /// Keeps the axes of two frames aligned, as `same_axes<A, B>`; together with `coincident`, it closes a loop
  /// with a weld. Half turns satisfy it as well, so the motion must start with aligned axes.
  zero_components same_axes(frame_id frame, frame_id other);
  /// Keeps two points at a fixed distance, like a massless rod: an expression for `configuration_constraint`,
  /// whose multiplier times −2 l is the tension.
  expression rod_of_length(point_id point, point_id other, expression length);

  /// An expression in the coordinates that must vanish.
  void configuration_constraint(expression vanishes);
  /// Requires the components of a position along given directions to vanish; see `zero_along`.
  void configuration_constraint(const zero_components& v);
  /// An expression that must vanish; it depends on the speeds or the rates of the coordinates, linearly or
  /// not.
  void velocity_constraint(expression vanishes);
  /// Requires the component of a velocity along `direction` to vanish.
  void velocity_constraint(const vector& vanishes, const vector& direction);
  /// Requires the components of a velocity along given directions to vanish; see `zero_along`.
  void velocity_constraint(const zero_components& v);
  /// An expression that must vanish and is linear in the rates of the speeds, such as `dot(u1) + dot(u2)`.
  void acceleration_constraint(expression vanishes);
  /// Selects a coordinate or speed for which the constraints are solved.
  void dependent(expression e);
  /// Declares that a configuration constraint, numbered from 1, follows from the others at every position
  /// that satisfies them all.
  void redundant(int configuration_constraint) {
    system_.constraints.redundant.push(configuration_constraint);
  }

protected:
  constraint_builder(builder_core& core, point_builder& points) : builder_part(core), points_(points) {}
  ~constraint_builder() = default;

private:
  vector axis_of(frame_id frame, int index) const;
  bool is_valid_direction(const vector& v, const vector& direction, std::string_view whose);

  point_builder& points_;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/constraint_builder.ipp>
#endif
