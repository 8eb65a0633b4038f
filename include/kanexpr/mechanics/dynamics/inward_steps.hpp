#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/flexible_part.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>

/// The order in which inertia is gathered from the tips of a mechanism inward.
namespace kanexpr::mechanics {

/// One motion between a body and the next one inward: a frame rotates at a station, or a station moves.
struct inward_step {
  int station = none;
  int frame = none; ///< the frame that rotates; none if the station moves
  int below = none; ///< the frame of the body inward

  constexpr bool is_rotation() const { return frame != none; }
  /// The frame of the body outward.
  constexpr int moved() const { return is_rotation() ? frame : below; }
};

namespace detail {

/// The frames of the bodies at each station, while the steps are listed.
class inward_order {
public:
  constexpr explicit inward_order(const skeleton& s) : s_(s), frames_(s.stations.size()) {
    for (const link& l : s_.base_links) add(l.station, l.frame);
    for (const flexible_part& p : s_.flexible_parts) add(p.station, p.frame);
    for (int n = s_.stations.size() - 1; n >= 0; --n) {
      while (turn_deepest(n)) {
      }
      move(n);
    }
  }
  constexpr const sequence<inward_step>& steps() const { return steps_; }

private:
  constexpr void add(int n, int frame) {
    if (!frames_[n].contains(frame)) frames_[n].push(frame);
  }

  /// The outermost frame at a station rotates.
  constexpr bool turn_deepest(int n) {
    sequence<int>& frames = frames_[n];
    int found = none, depth = -1;
    for (int i = 0; i < frames.size(); ++i) {
      if (frames[i] == s_.stations[n].frame || frames[i] == mechanism::inertial) continue;
      const int d = depth_of(frames[i]);
      if (d > depth) found = i, depth = d;
    }
    if (found == none) return false;
    const int frame = frames[found], below = s_.turns_in[frame];
    frames[found] = frames.back();
    frames.pop();
    steps_.push({n, frame, below});
    add(n, below);
    return true;
  }

  constexpr void move(int n) {
    if (frames_[n].empty()) return;
    const station& at = s_.stations[n];
    steps_.push({n, none, at.frame});
    if (!at.absolute && at.parent != none) add(at.parent, at.frame);
  }

  constexpr int depth_of(int f) const {
    int n = 0;
    for (; f != mechanism::inertial; f = s_.turns_in[f]) ++n;
    return n;
  }

  const skeleton& s_;
  sequence<sequence<int>> frames_;
  sequence<inward_step> steps_{};
};

} // namespace detail

/// The steps from the tips to the ground. All steps of a station precede those of its parent.
constexpr sequence<inward_step> inward_steps(const skeleton& s) { return detail::inward_order(s).steps(); }

} // namespace kanexpr::mechanics
