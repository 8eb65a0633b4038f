#pragma once

#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/mechanics/loads/add_path_load.hpp>
#include <kanexpr/mechanics/loads/bushing.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/path_load.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Readers of loads along pathways, and of bushings.
namespace kanexpr::derivation {

constexpr void read_path_force(load_parts& by) {
  const mechanics::pathway along = by.path();
  const expression tension = by.scalar(by.record.value, "");
  if (!by.has_mistake()) mechanics::add_force_along(by.into, along, tension);
}

constexpr void read_path_spring(load_parts& by) {
  const mechanics::pathway along = by.path();
  const expression stiffness = by.term(0, "the stiffness of ");
  const expression length = by.term(1, "the natural length of ");
  if (!by.has_mistake()) mechanics::add_spring_along(by.into, along, stiffness, by.model().zero(), length);
}

constexpr void read_path_cubic_spring(load_parts& by) {
  const mechanics::pathway along = by.path();
  const expression stiffness = by.term(0, "the stiffness of ");
  const expression cubic = by.term(1, "the cubic stiffness of ");
  const expression length = by.term(2, "the natural length of ");
  if (!by.has_mistake()) mechanics::add_spring_along(by.into, along, stiffness, cubic, length);
}

constexpr void read_path_damper(load_parts& by) {
  const mechanics::pathway along = by.path();
  const expression damping = by.scalar(by.record.value, "the damping of ");
  if (!by.has_mistake()) mechanics::add_damper_along(by.into, along, damping);
}

constexpr void read_path_stop(load_parts& by) {
  const mechanics::pathway along = by.path();
  mechanics::stop_at_ends ends{by.term(0, "the least length of "), by.term(1, "the greatest length of "),
                               by.term(2, "the stiffness of "), by.term(3, "the damping of ")};
  if (by.record.terms_given > 4) ends.width = by.term(4, "the width of ");
  if (!by.has_mistake()) mechanics::add_stop(by.into, along, ends);
}

/// The tension of the only load; a straight spring or damper is not an element.
constexpr expression tension_along_path(const mechanics::loads& alone, mechanics::observed_motion& on) {
  if (!alone.spring_dampers.empty()) return alone.spring_dampers[0].tension(on);
  return alone.all<mechanics::path_load>()[0].tension(on);
}

constexpr void read_bushing(load_parts& by) {
  mechanics::bushing b;
  const auto [on, other] = by.frames();
  const auto [at, base] = by.points();
  b.frame = on, b.against = other, b.place = at, b.base = base;
  for (int i = 0; i < 12; ++i) {
    const bool is_given = i < by.record.terms_given && !by.has_mistake();
    const expression term =
        is_given ? by.term(i, i < 6 ? "a stiffness of " : "a damping of ") : by.model().zero();
    (i < 6 ? b.stiffness : b.damping).push(term);
  }
  if (!by.has_mistake()) by.into.add(b);
}

} // namespace kanexpr::derivation
