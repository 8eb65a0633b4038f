#pragma once

#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/symbolic/operation_weights.hpp>

namespace kanexpr::runtime {

/// How the equations of a builder's system are formed, where this is not left to the library. The motion does
/// not depend on it. `explain(b)` compares the forms.
class formulation_builder : private builder_part {
public:
  /// Takes over the form of a candidate of `explain(b)`.
  void formulation(const mechanics::formulation& form) { m_.formulated = form; }
  /// Writes the equations of all bodies that move with a frame in the axes of another frame.
  void written_in(frame_id frame, frame_id axes);
  /// Writes the equations of the bodies that move with a frame about their mass centers.
  void about_mass_center(frame_id frame);
  /// Finds u̇ from M u̇ = f by elimination.
  void by_elimination() { m_.formulated.solved_by = mechanics::solution::elimination; }
  /// Finds u̇ of a tree of rigid bodies by articulated bodies.
  void by_articulated_bodies() { m_.formulated.solved_by = mechanics::solution::articulated_bodies; }
  /// Forms the equations of bodies that rotate about parallel axes of the ground for their angular velocities
  /// in the ground, and finds u̇ from the rates of these.
  void in_absolute_speeds() { m_.formulated.speeds = mechanics::internal_speeds::absolute; }
  /// What operations cost on the target, for the choices that the library makes.
  void weighted_by(const symbolic::operation_weights& weights);

protected:
  explicit formulation_builder(builder_core& core) : builder_part(core) {}
  ~formulation_builder() = default;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/formulation_builder.ipp>
#endif
