#pragma once

#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/tyre.hpp>
#include <kanexpr/mechanics/loads/tyre_slip.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// The forces and slips of loads, as results.
namespace kanexpr::derivation {

/// The word by which a model requests a quantity.
constexpr std::string_view word_of(describe::load_quantity what) {
  using enum describe::load_quantity;
  switch (what) {
  case length: return "length_of";
  case tension: return "tension_of";
  case normal_force: return "normal_force_of";
  case longitudinal_force: return "longitudinal_force_of";
  case lateral_force: return "lateral_force_of";
  case aligning_moment: return "aligning_moment_of";
  case longitudinal_slip: return "longitudinal_slip_of";
  case lateral_slip: return "lateral_slip_of";
  case camber: return "sine_of_camber_of";
  case friction_force: return "friction_force_of";
  case contact_force:
  case contact_place: return "show_forces";
  }
  return {};
}

/// A quantity of a tyre.
constexpr symbolic::expression quantity_of_tyre(describe::load_quantity wanted, const mechanics::tyre& load,
                                                mechanics::observed_motion& on) {
  using enum describe::load_quantity;
  const mechanics::tyre_slip slip = load.slip(on);
  if (wanted == longitudinal_slip) return slip.forward;
  if (wanted == lateral_slip) return -slip.lateral;
  if (wanted == camber) return slip.camber;
  if (wanted == normal_force) return slip.load;
  const mechanics::tyre_effort effort = load.effort(on);
  return wanted == longitudinal_force ? effort.forward
         : wanted == lateral_force    ? effort.lateral
                                      : effort.aligning;
}

/// A quantity of the only load in a list.
constexpr value observed_quantity(describe::load_quantity wanted, const mechanics::loads& alone,
                                  mechanics::motion& moving) {
  using enum describe::load_quantity;
  mechanics::observed_motion on(moving);
  value found;
  alone.each([&](const auto& load, int) {
    if constexpr (requires { load.tension(on); }) {
      if (wanted == tension) found = value::of(load.tension(on));
    }
    if constexpr (requires { load.normal_force(on); }) {
      if (wanted == normal_force) found = value::of(load.normal_force(on));
      if (wanted == friction_force) found = value::of(load.friction_force(on));
      if (wanted == contact_force) found = value::of(load.force(on));
      if (wanted == contact_place) found = value::of(load.place(on));
    }
    if constexpr (requires { load.effort(on); }) found = value::of(quantity_of_tyre(wanted, load, on));
  });
  return found;
}

} // namespace kanexpr::derivation
