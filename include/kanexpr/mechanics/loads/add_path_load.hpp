#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/path_load.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/loads/spring_damper.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::mechanics {

/// Whether a pathway is the straight line between two points, along which a spring or a damper needs no
/// general pathway.
constexpr bool is_straight(const pathway& p) {
  return p.form == pathway_form::through_points && p.points.size() == 2;
}

constexpr void add_force_along(loads& to, const pathway& along, expression tension) {
  to.add(path_load{along, tension_law::given, {tension}});
}

/// Adds a spring with the tension k x + k₃ x³.
constexpr void add_spring_along(loads& to, const pathway& along, expression stiffness, expression cubic,
                                expression length) {
  if (is_straight(along) && cubic.is_zero())
    return add_spring(to.spring_dampers, along.points[0], along.points[1], stiffness, length);
  to.add(path_load{along, tension_law::spring, {stiffness, cubic, length}});
}

constexpr void add_damper_along(loads& to, const pathway& along, expression damping) {
  if (is_straight(along)) return add_damper(to.spring_dampers, along.points[0], along.points[1], damping);
  to.add(path_load{along, tension_law::damper, {damping}});
}

constexpr void add_friction_along(loads& to, const pathway& along, expression normal_force,
                                  const friction_law& law) {
  to.add(path_load{along, tension_law::friction, {normal_force}, law});
}

/// A stop at a least and at a greatest length; the width is the default one if it is not given.
struct stop_at_ends {
  expression least{}, greatest{}, stiffness{}, damping{}, width{};
};

constexpr void add_stop(loads& to, const pathway& along, const stop_at_ends& by) {
  const expression width = by.width.is_given() ? by.width : default_width_of_stop(by.least, by.greatest);
  to.add(path_load{along, tension_law::stop, {by.least, by.greatest, by.stiffness, by.damping, width}});
}

} // namespace kanexpr::mechanics
