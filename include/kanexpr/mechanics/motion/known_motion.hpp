#pragma once

#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/skeleton/auxiliary.hpp>
#include <kanexpr/mechanics/skeleton/skeleton_of.hpp>

#include <utility>

namespace kanexpr::mechanics {

/// The motion of a mechanism, known before loads and constraints are, so that these can speak of it.
/// Velocities and accelerations are formed when they are asked for, with the symbols u̇.
class known_motion {
public:
  constexpr explicit known_motion(const mechanism& m) : skeleton_(skeleton_of(m)) {}
  /// To be read from what was set aside.
  struct set_aside {};
  constexpr known_motion(const mechanism& m, set_aside) : skeleton_{&m} {}
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
    visit(self.skeleton_); // motions are formed again at little cost
    visit(self.is_without_auxiliary_);
  }

  constexpr const skeleton& skeleton_used() const { return skeleton_; }

  /// With the frames and points that the mechanism was given since.
  constexpr motion& moving() {
    if (lacks_any()) extend();
    if (!has_motion_) motion_ = motion(skeleton_, skeleton_.model->speed_rates);
    has_motion_ = true;
    return motion_;
  }

  /// From here on they are zero, once partial velocities have told what they bring out.
  constexpr void drop_auxiliary_speeds() {
    is_without_auxiliary_ = true;
    if (skeleton_.model->auxiliary_speeds.empty()) return;
    mechanics::drop_auxiliary_speeds(skeleton_);
    has_motion_ = false;
  }

  /// Whether the mechanism was given frames or points since.
  constexpr bool lacks_any() const { return skeleton_.lacks_any(); }
  /// Takes them up, for expressions that speak of them.
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
