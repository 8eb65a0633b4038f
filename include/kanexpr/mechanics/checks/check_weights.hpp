#pragma once

#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>

/// What acts twice, or is a force where an acceleration is wanted.
namespace kanexpr::mechanics {

constexpr bool is_same(const vector& a, const vector& b) { return !a.is_zero() && (a - b).is_zero(); }

constexpr void check_repeated_forces(const loads& acting, load_check& by) {
  for (int i = 0; i < acting.forces.size(); ++i)
    for (int j = 0; j < i; ++j) {
      const force &one = acting.forces[i], &other = acting.forces[j];
      if (one.point != other.point || one.against != other.against || !is_same(one.value, other.value))
        continue;
      if (one.against == none) return by.fail({"the force at ", by.point(one.point), " is listed twice"});
      return by.fail(
          {"the force between ", by.both_points(one.point, one.against).view(), " is listed twice"});
    }
  for (int i = 0; i < acting.torques.size(); ++i)
    for (int j = 0; j < i; ++j) {
      const torque &one = acting.torques[i], &other = acting.torques[j];
      if (one.frame != other.frame || one.against != other.against || !is_same(one.value, other.value))
        continue;
      if (one.against == none) return by.fail({"the torque on ", by.frame(one.frame), " is listed twice"});
      return by.fail(
          {"the torque between ", by.both_frames(one.frame, one.against).view(), " is listed twice"});
    }
}

/// Gravity that holds the mass of a body, or stands beside a body's weight.
constexpr void check_weights(const mechanism& m, const loads& acting, load_check& by) {
  if (!acting.has_gravity) return;
  for (const body& b : m.bodies) {
    for (const expression& p : m.parameters)
      if (p == b.mass)
        for (const vector::part& part : acting.gravity.parts)
          for (int i = 0; i < 3; ++i)
            if (!symbolic::differentiate(part.value[i], p).is_zero())
              return by.fail({"gravity holds ", m.g->symbol_at(p.node()).called.view(), ", the mass of ",
                              b.called.view(), "; it is the acceleration of free fall, not a weight"});
    for (const force& f : acting.forces)
      if (f.point == b.center && f.against == none && is_same(f.value, b.mass * acting.gravity))
        return by.fail({"the force at ", by.point(f.point), " is the weight of ", b.called.view(),
                        ", which gravity gives it already"});
  }
}

} // namespace kanexpr::mechanics
