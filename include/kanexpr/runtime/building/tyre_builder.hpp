#pragma once

#include <kanexpr/mechanics/loads/tyre_law.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/runtime/building/tyre_data.hpp>
#include <kanexpr/runtime/building/wheel_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::runtime {

/// The tyres of a builder.
class tyre_builder : private builder_part {
public:
  /// A tyre on a wheel, as `tyre<…>`.
  void tyre(const wheel_on_ground& wheel, const tyre_data& data);
  /// The forces and slips of a tyre, numbered from 1 in the order in which tyres were added.
  tyre_forces forces_of_tyre(int tyre, mechanics::known_motion& known);

protected:
  explicit tyre_builder(builder_core& core) : builder_part(core) {}
  ~tyre_builder() = default;

private:
  expression value_of(const tyre_data::value& given);
  mechanics::tyre_law law_of(const tyre_data& data);
  int deflection(expression state_variable);
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/tyre_builder.ipp>
#endif
