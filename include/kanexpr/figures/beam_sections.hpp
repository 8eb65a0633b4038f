#pragma once

#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/beam_outline.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/section.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <optional>
#include <vector>

/// The sections along the beams of a model that is drawn.
namespace kanexpr::figures {

/// Equally spaced sections of a beam, from its root to its tip, as points and frames.
struct beam_sections {
  int body = mechanics::none; ///< the index of the flexible body
  std::vector<int> points{}, frames{};
};

/// A copy of a mechanism, to which the sections of all beams with an outline are added.
struct mechanism_with_sections {
  mechanics::mechanism mechanism;
  std::vector<beam_sections> beams{};

  explicit mechanism_with_sections(const mechanics::mechanism& of) : mechanism(of) {
    for (int i = 0; i < of.flexible_bodies.size(); ++i)
      if (of.flexible_bodies[i].outline.is_given()) add(i);
  }

private:
  void add(int body) {
    const mechanics::flexible_body& f = mechanism.flexible_bodies[body];
    const mechanics::beam beam = mechanics::outlined_beam(f);
    beam_sections made{.body = body};
    for (int i = 0; i < mechanics::beam_outline::sections; ++i) {
      made.points.push_back(mechanics::add_point_of_section(mechanism, f.called, beam, f.outline.section(i)));
      made.frames.push_back(mechanics::add_frame_of_section(mechanism, f.called, beam, f.outline.section(i)));
    }
    beams.push_back(made);
  }
};

/// A direction across a beam: the first one in which it bends, if there is one.
inline mechanics::components across_beam(const mechanics::flexible_body& f) {
  for (const mechanics::components& each : f.outline.across)
    if (!each.is_zero()) return each;
  const mechanics::components x = mechanics::unit(f.outline.length.owner(), 0),
                              across = cross(f.outline.axis, x);
  return across.is_zero() ? mechanics::unit(f.outline.length.owner(), 1) : across;
}

/// Finds the frames and points that move with the deflections of flexible bodies.
class deflections {
public:
  explicit deflections(const mechanics::mechanism& m) : m_(m) {
    if (!m.flexible_bodies.empty()) held_.emplace(*m.g);
  }

  /// Whether the orientation of a frame in its parent depends on a deflection.
  bool turn(const mechanics::frame& f) const {
    if (!held_) return false;
    bool turns = false;
    for (const symbolic::expression& e : f.scalars()) turns = turns || contains_amplitude(e);
    return turns;
  }
  /// Whether the offset of a point from its parent depends on a deflection.
  bool move(const mechanics::point& p) const {
    if (!held_) return false;
    bool moves = false;
    p.offset.each_entry([&](const symbolic::expression& e) { moves = moves || contains_amplitude(e); });
    return moves;
  }

private:
  bool contains_amplitude(const symbolic::expression& e) const {
    for (const int symbol : held_->symbols_in(e, {symbolic::symbol_kind::coordinate}))
      for (const mechanics::flexible_body& b : m_.flexible_bodies)
        if (b.amplitudes.contains(symbolic::expression(*m_.g, symbol))) return true;
    return false;
  }

  const mechanics::mechanism& m_;
  std::optional<mechanics::contents> held_{};
};

} // namespace kanexpr::figures
