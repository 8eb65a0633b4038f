#pragma once

#include <kanexpr/figures/outlines.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace kanexpr::animate {

/// A straight piece of an offset, between two places.
struct straight_piece {
  int part = mechanics::none; ///< the frame that represents the rigid part along whose axes the piece lies
  int from = mechanics::none, to = mechanics::none; ///< places
};

/// The rigid parts of a mechanism, found from its frames and points. Frames at constant orientations relative
/// to each other belong to one part, which is represented by the first of them; frame 0 represents the
/// inertial frame.
class rigid_parts {
public:
  explicit rigid_parts(const mechanics::mechanism& m) : m_(m), deflections_(m) {
    for (int f = 0; f < m.frames.size(); ++f)
      part_of_frame_.push_back(f == 0 || turns(f) ? f : part_of(m.frames[f].parent));
    for (int i = 0; i < m.points.size(); ++i) {
      places_.push_back(mechanics::position_from_origin(m, i));
      is_free_.push_back(false);
    }
    for (int i = 0; i < m.points.size(); ++i)
      if (m.points[i].parent != mechanics::none) add_offset(i);
  }

  int part_of(int frame) const { return part_of_frame_[static_cast<std::size_t>(frame)]; }
  /// The positions relative to the origins: those of the points, followed by corners of their offsets.
  const std::vector<mechanics::vector>& places() const { return places_; }
  /// Pieces of constant length, which connect places of the same part.
  const std::vector<straight_piece>& links() const { return links_; }
  /// Pieces along which a place slides relative to a part.
  const std::vector<straight_piece>& slides() const { return slides_; }

  bool has_links(int part) const {
    return std::ranges::any_of(links_, [&](const straight_piece& l) { return l.part == part; });
  }
  int body_of(int part) const {
    for (int i = 0; i < m_.bodies.size(); ++i)
      if (m_.bodies[i].frame != mechanics::none && part_of(m_.bodies[i].frame) == part) return i;
    return mechanics::none;
  }
  /// Whether a point is an origin or is connected to one by links and slides.
  bool is_supported(int point) const {
    while (m_.points[point].parent != mechanics::none) {
      if (is_free_[static_cast<std::size_t>(point)]) return false;
      if (!m_.points[point].offset.is_zero()) return true;
      point = m_.points[point].parent;
    }
    return true;
  }
  /// The point about which a part rotates relative to the part that carries it; none if there is no such
  /// point in the model.
  int joint_of(int part) const;

private:
  /// Whether the orientation of a frame relative to its parent changes.
  bool turns(int f) const {
    const mechanics::frame& frame = m_.frames[f];
    if (frame.has_declared_angular_velocity())
      return true; // it may spin by an angle that is not a coordinate
    if (frame.kind == mechanics::orientation::about_axis && !mechanics::is_fixed(frame.direction))
      return true;
    for (const symbolic::expression& e : frame.scalars())
      if (!mechanics::is_fixed(e)) return true;
    return false;
  }

  void add_offset(int point);

  const mechanics::mechanism& m_;
  figures::deflections deflections_;
  std::vector<int> part_of_frame_{};
  std::vector<bool> is_free_{}; ///< for each point, whether it moves in several directions
  std::vector<mechanics::vector> places_{};
  std::vector<straight_piece> links_{}, slides_{};
};

/// Divides the offset of a point into pieces, from the ground outward. If it contains components that vary in
/// several directions, the point moves freely and there are none; nor are there any within a flexible body.
inline void rigid_parts::add_offset(int point) {
  if (deflections_.move(m_.points[point])) return;
  struct step {
    int frame = mechanics::none;
    mechanics::components along{};
    bool slides = false;
  };
  std::vector<step> steps;
  int varying = 0;
  for (const mechanics::vector::part& p : m_.points[point].offset.parts) {
    mechanics::components constant(*m_.g), changing(*m_.g);
    for (int i = 0; i < 3; ++i) {
      const bool is_constant = mechanics::is_fixed(p.value[i]);
      (is_constant ? constant : changing)[i] = p.value[i];
      varying += is_constant ? 0 : 1;
    }
    if (!constant.is_zero()) steps.push_back({p.frame, constant, false});
    if (!changing.is_zero()) steps.push_back({p.frame, changing, true});
  }
  if (varying > 1) {
    is_free_[static_cast<std::size_t>(point)] = true;
    return;
  }
  std::ranges::sort(steps, {}, [](const step& s) { return std::pair(s.frame, s.slides); });
  mechanics::vector reached = mechanics::position_from_origin(m_, m_.points[point].parent);
  int from = m_.points[point].parent;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    int to = point;
    reached.add(steps[i].frame, steps[i].along);
    if (i + 1 < steps.size()) {
      to = static_cast<int>(places_.size());
      places_.push_back(reached);
    }
    (steps[i].slides ? slides_ : links_).push_back({part_of(steps[i].frame), from, to});
    from = to;
  }
}

inline int rigid_parts::joint_of(int part) const {
  const int points = m_.points.size();
  for (int i = 0; i < points; ++i) // in the order of the model
    for (const auto* pieces : {&links_, &slides_})
      for (const straight_piece& each : *pieces)
        if (each.part == part && each.to == i && each.from < points) return each.from;
  for (const mechanics::body& b : m_.bodies)
    if (b.frame != mechanics::none && part_of(b.frame) == part) return b.center;
  for (int f = part + 1; f < m_.frames.size(); ++f) // an intermediate frame rotates about the same point
    if (part_of(f) == f && part_of(m_.frames[f].parent) == part) return joint_of(f);
  return mechanics::none;
}

} // namespace kanexpr::animate
