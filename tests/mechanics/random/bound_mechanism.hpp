// A random mechanism with random constraints, derived at run time.
#pragma once

#include "build_recipe.hpp"
#include "random_constraints.hpp"

#include <kanexpr/mechanics/motion/observe.hpp>

namespace recipe {

struct bound_mechanism {
  mechanism& m;
  builder b{"N"};
  building built;
  kanexpr::mechanics::known_motion known;
  kanexpr::mechanics::equations derived;

  bound_mechanism(mechanism& of, const std::vector<constraint>& bounds)
      : m(of), built(m, b), known(b.mechanism()), derived(b.system()) {
    for (const constraint& c : bounds) bind(c);
  }

  Eigen::MatrixXd found(kanexpr::mechanics::quantity q) { return number(m, derived.get(q)); }

private:
  void bind(const constraint& c) {
    namespace mechanics = kanexpr::mechanics;
    switch (c.what) {
    case bound::point: return b.velocity_constraint(velocity(c.one), built.vector(c.direction));
    case bound::points:
      return b.velocity_constraint(velocity(c.one) - velocity(c.other), built.vector(c.direction));
    case bound::turning:
      return b.velocity_constraint(turning(c.one) - turning(c.other), built.vector(c.direction));
    case bound::speeds: {
      recipe::expression total = built.scalar(c.rest);
      for (std::size_t i = 0; i < m.u.size(); ++i)
        total += built.scalar(c.on_speeds[i]) * built.speed(static_cast<int>(i));
      for (std::size_t i = 0; i < m.q.size(); ++i)
        total += built.scalar(c.on_rates[i]) * built.rate(static_cast<int>(i));
      return b.velocity_constraint(total);
    }
    case bound::configuration:
      return b.configuration_constraint(built.scalar(c.product[0]) * built.scalar(c.product[1]) +
                                        built.scalar(c.rest));
    }
  }
  kanexpr::runtime::vector velocity(int point) {
    return kanexpr::mechanics::velocity_of_point(known.moving(), place(built.points[at(point)]));
  }
  kanexpr::runtime::vector turning(int frame) {
    return kanexpr::mechanics::angular_velocity_of_frame(known.moving(), place(built.frames[at(frame)]));
  }
};

} // namespace recipe
