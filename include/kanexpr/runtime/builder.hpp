#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/building/beam_builder.hpp>
#include <kanexpr/runtime/building/block_builder.hpp>
#include <kanexpr/runtime/building/body_builder.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/runtime/building/constraint_builder.hpp>
#include <kanexpr/runtime/building/contact_builder.hpp>
#include <kanexpr/runtime/building/flexible_body_builder.hpp>
#include <kanexpr/runtime/building/formulation_builder.hpp>
#include <kanexpr/runtime/building/frame_builder.hpp>
#include <kanexpr/runtime/building/load_builder.hpp>
#include <kanexpr/runtime/building/motion_builder.hpp>
#include <kanexpr/runtime/building/pathway_builder.hpp>
#include <kanexpr/runtime/building/point_builder.hpp>
#include <kanexpr/runtime/building/scalar_builder.hpp>
#include <kanexpr/runtime/building/tyre_builder.hpp>
#include <kanexpr/runtime/building/vector_builder.hpp>
#include <kanexpr/runtime/building/wheel_builder.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr {

namespace runtime {
class builder;
}

/// Derives the system built so far; later calls to the builder do not change the model. A mistake made in the
/// builder also counts as a mistake in the model.
KANEXPR_ENGINE model derive(const runtime::builder& built);

namespace runtime {

/// Derives the system in a separate graph. Its expressions belong only to the model and depend neither on the
/// compiler nor on earlier derivations.
KANEXPR_ENGINE model derive_in_own_graph(const builder& built);

} // namespace runtime

} // namespace kanexpr

namespace kanexpr::runtime {

/// Builds a system from values at run time. A builder cannot be copied or moved. `derive(b)` returns a model
/// of the system, which has the same results as a system described by types.
///
/// A mistake does not stop the program: the first one is stored as a sentence, and the invalid item is
/// omitted.
///
/// Loads and constraints may contain velocities. After frames and points have been defined,
/// `mechanics::known_motion known(b.mechanism());` provides them.
///
/// Each base class, in a header of `building/`, has the functions that add one kind of entity.
class builder : private builder_core,
                public scalar_builder,
                public vector_builder,
                public frame_builder,
                public point_builder,
                public body_builder,
                public flexible_body_builder,
                public beam_builder,
                public load_builder,
                public pathway_builder,
                public block_builder,
                public contact_builder,
                public wheel_builder,
                public tyre_builder,
                public motion_builder,
                public constraint_builder,
                public formulation_builder {
public:
  explicit builder(std::string_view inertial_frame);
  builder(const builder&) = delete;
  builder& operator=(const builder&) = delete;

  /// The first mistake made while building, or the first in the resulting system; empty if there is none.
  sentence(check)() const;
  const sentence& mistake() const { return checks_.mistake(); }

  /// The units of the symbols and constraints of the system built so far, as far as they are determined.
  mechanics::unit_table units() const;
  /// The unit of an expression; nothing if it is not determined.
  mechanics::possible_unit unit_of(expression e) const;

  const mechanics::multibody_system& system() const { return system_; }
  const mechanics::mechanism& mechanism() const { return system_.mechanism; }
  symbolic::graph& graph() { return *graph_; }

  using scalar_builder::dot, vector_builder::dot;

protected:
  /// Reports a mistake in what a derived class builds the system from.
  void report(std::string_view mistake) { checks_.fail({mistake}); }
  /// Gives the unit of an expression that follows from its definition; the units of the system are not
  /// checked because of it.
  void imply_unit(expression e, const units::unit& u) { system_.mechanism.stated_units.push({e, u, true}); }
  /// Declares that the quantities of all parts built so far are in SI units by definition.
  void trust_units_of_present_parts() { system_.trust_units_of_present_parts(); }

private:
  friend model kanexpr::derive(const builder& built);

  using builder_core::checks_, builder_core::graph_, builder_core::system_, builder_core::used_elsewhere_;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/builder.ipp>
#endif
