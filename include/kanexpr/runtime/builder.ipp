#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/checks/check.hpp>
#include <kanexpr/mechanics/checks/check_units.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/units/unit_inference.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/derived.ipp>
#include <kanexpr/runtime/system_expressions.ipp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <memory>
#include <optional>
#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE builder::builder(std::string_view inertial_frame)
    : builder_core(), scalar_builder(core()), vector_builder(core()), frame_builder(core()),
      point_builder(core()), body_builder(core()), flexible_body_builder(core(), *this, *this),
      beam_builder(core()), load_builder(core()), pathway_builder(core()), block_builder(core(), *this),
      contact_builder(core()), wheel_builder(core(), *this), tyre_builder(core()), motion_builder(core()),
      constraint_builder(core(), *this), formulation_builder(core()) {
  checks_.is_new("frames", inertial_frame, system_.mechanism.frames);
  mechanics::add_inertial_frame(system_.mechanism, inertial_frame);
}

KANEXPR_ENGINE sentence(builder::check)() const {
  if (mistake()) return mistake();
  sentence found = mechanics::check_system(system_);
  if (!found && mechanism().state_variables != 0)
    found = mechanics::check_state_rates(mechanism(), system_.loads.state_rates);
  if (!found) found = check_unused_symbols(system_, used_elsewhere_);
  return found ? found : mechanics::check_units(system_);
}

KANEXPR_ENGINE mechanics::unit_table builder::units() const { return mechanics::unit_table_of(system_); }

KANEXPR_ENGINE mechanics::possible_unit builder::unit_of(expression e) const {
  if (!e.belongs_to(*graph_)) return std::nullopt;
  mechanics::unit_inference inferred(mechanism());
  mechanics::system_units(system_, inferred).state();
  return inferred.unit_of(e);
}

} // namespace kanexpr::runtime

namespace kanexpr {

KANEXPR_ENGINE model derive(const runtime::builder& built) {
  return model(
      std::make_shared<runtime::derived_from_builder>(built.graph_, built.system(), (built.check)()));
}

KANEXPR_ENGINE model runtime::derive_in_own_graph(const builder& built) {
  const auto own = std::make_shared<symbolic::graph>();
  mechanics::multibody_system system(built.system());
  copy_to_graph(*own, system);
  return model(std::make_shared<derived_from_builder>(own, system, (built.check)()));
}

} // namespace kanexpr
