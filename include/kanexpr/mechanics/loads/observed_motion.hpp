#pragma once

#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// A motion in which the force of a load is observed, in place of the force system on which it acts. The
/// rates of the coordinates remain symbols.
class observed_motion {
public:
  constexpr explicit observed_motion(motion& k) : motion_(k) {}

  constexpr const skeleton& skeleton_used() const { return motion_.skeleton_used(); }
  constexpr motion& moving() { return motion_; }
  static constexpr expression known(expression e) { return e; }

private:
  motion& motion_;
};

} // namespace kanexpr::mechanics
