#pragma once

#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/beam_outline.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/mechanics/model/flexible_expressions.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/section.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// The places at which the flexible bodies of a model are drawn: sections of beams and nodes of other bodies.
namespace kanexpr::figures {

/// Equally spaced sections of a beam, from its root to its tip, as points and frames.
struct beam_sections {
  int body = mechanics::none; ///< the index of the flexible body
  std::vector<int> points{}, frames{};
};

/// The nodes of a flexible body that is given by numbers.
struct body_nodes {
  int body = mechanics::none; ///< the index of the flexible body
  std::vector<int> points{};
};

/// A copy of a mechanism, to which the sections of its beams and the nodes of other flexible bodies are
/// added.
struct outlined_mechanism {
  mechanics::mechanism mechanism;
  std::vector<beam_sections> beams{};
  std::vector<body_nodes> nodes{};

  explicit outlined_mechanism(const mechanics::mechanism& of) : mechanism(of) {
    for (int i = 0; i < of.flexible_bodies.size(); ++i) {
      if (of.flexible_bodies[i].outline.is_given()) add_beam(i);
      if (!of.flexible_bodies[i].nodes.all.empty()) add_nodes(i);
    }
  }

  std::vector<std::vector<int>> points_of_beams() const { return points_of(beams); }
  std::vector<std::vector<int>> points_of_nodes() const { return points_of(nodes); }

private:
  template <class Body>
  static std::vector<std::vector<int>> points_of(const std::vector<Body>& bodies) {
    std::vector<std::vector<int>> all;
    all.reserve(bodies.size());
    for (const Body& each : bodies) all.push_back(each.points);
    return all;
  }

  void add_beam(int body) {
    const mechanics::flexible_body& f = mechanism.flexible_bodies[body];
    const mechanics::beam beam = mechanics::outlined_beam(f);
    beam_sections made{.body = body};
    for (int i = 0; i < mechanics::beam_outline::sections; ++i) {
      made.points.push_back(mechanics::add_point_of_section(mechanism, f.called, beam, f.outline.section(i)));
      made.frames.push_back(mechanics::add_frame_of_section(mechanism, f.called, beam, f.outline.section(i)));
    }
    beams.push_back(made);
  }

  void add_nodes(int body) {
    const mechanics::flexible_body& f = mechanism.flexible_bodies[body];
    const mechanics::flexible_data numbers(f.amplitudes.size());
    const mechanics::flexible_expressions of(numbers, f.amplitudes);
    body_nodes made{.body = body};
    for (const mechanics::flexible_node& node : f.nodes.all) {
      mechanics::point p;
      p.called = node.called;
      p.parent = f.reference;
      p.offset.add(f.frame, of.position(node));
      made.points.push_back(mechanism.points.push(p));
    }
    nodes.push_back(made);
  }
};

/// The lines of least total length that connect all places (Prim's algorithm), as pairs of indices. Nodes are
/// given without the elements between them.
inline std::vector<std::pair<std::size_t, std::size_t>>
shortest_connections(const std::vector<Eigen::Vector3d>& places) {
  std::vector<std::pair<std::size_t, std::size_t>> lines;
  std::vector<std::size_t> nearest(places.size(), 0);
  std::vector<bool> is_connected(places.size(), false);
  const auto distance = [&](std::size_t i) { return (places[i] - places[nearest[i]]).norm(); };
  for (std::size_t count = 1; count < places.size(); ++count) {
    std::size_t next = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
      if (!is_connected[i] && (next == 0 || distance(i) < distance(next))) next = i;
    is_connected[next] = true;
    lines.emplace_back(nearest[next], next);
    for (std::size_t i = 1; i < places.size(); ++i)
      if (!is_connected[i] && (places[i] - places[next]).norm() < distance(i)) nearest[i] = next;
  }
  return lines;
}

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
