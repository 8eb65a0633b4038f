#pragma once

#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/skeleton_of.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>

#include <utility>

namespace kanexpr::mechanics {

/// The motion of a mechanism. It is available before its loads and constraints, so that these can refer to
/// it. Velocities and accelerations are formed on first use, with the symbols u̇.
class known_motion {
public:
  constexpr explicit known_motion(const mechanism& m) : skeleton_(skeleton_of(m)) {}
  /// Selects the constructor of an empty object to be restored from stored members.
  struct for_restore {};
  constexpr known_motion(const mechanism& m, for_restore) : skeleton_{&m} {}
  constexpr known_motion(known_motion&& other) noexcept
      : skeleton_(std::move(other.skeleton_)), motion_(std::move(other.motion_)),
        has_motion_(other.has_motion_), is_without_auxiliary_(other.is_without_auxiliary_) {
    motion_.follow(skeleton_);
  }
  known_motion(const known_motion&) = delete;
  known_motion& operator=(const known_motion&) = delete;
  known_motion& operator=(known_motion&&) = delete;

  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.skeleton_, self.is_without_auxiliary_);
  }

  constexpr const skeleton& skeleton_used() const { return skeleton_; }

  /// The motion, including frames and points that were added to the mechanism later.
  constexpr motion& moving() {
    if (lacks_any()) extend();
    if (!has_motion_) motion_ = motion(skeleton_, skeleton_.model->speed_rates);
    has_motion_ = true;
    return motion_;
  }

  /// Sets the auxiliary speeds to zero from now on; their partial velocities are already known.
  constexpr void drop_auxiliary_speeds() {
    is_without_auxiliary_ = true;
    if (skeleton_.model->auxiliary_speeds.empty()) return;
    mechanics::drop_auxiliary_speeds(skeleton_);
    has_motion_ = false;
  }

  /// Whether frames or points have since been added to the mechanism.
  constexpr bool lacks_any() const { return skeleton_.lacks_any(); }
  /// Adds the new frames and points, so that expressions can refer to them.
  constexpr void extend() {
    mechanics::extend(skeleton_);
    if (is_without_auxiliary_) drop_auxiliary_speeds();
    has_motion_ = false;
  }

private:
  skeleton skeleton_;
  motion motion_{};
  bool has_motion_ = false, is_without_auxiliary_ = false;
};

} // namespace kanexpr::mechanics
