#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>

/// The quaternions of frames whose norm 1 the kinematic differential equations keep: no constraint, for no
/// speed is bound by it, but what numbers must not lose.
namespace kanexpr::mechanics {

namespace detail {

/// The places of the coordinates that a quaternion is made of, beside zeros; none if it holds anything else.
constexpr sequence<int> coordinates_of_quaternion(const mechanism& m, const frame& f) {
  sequence<int> places;
  for (const expression& entry : f.quaternion) {
    if (entry.is_zero()) continue;
    const int place = m.coordinates.find(entry);
    if (place < 0 || places.contains(place)) return {};
    places.push(place);
  }
  return places;
}

/// The kinematic differential equations at numbers: unit quaternions e, all else generic.
class kinematics_at_numbers {
public:
  constexpr kinematics_at_numbers(const mechanism& m, const sequence<int>& places)
      : m_(m), places_(places), evaluate_(*m.g, nodes_of(m)) {
    double square = 0;
    for (int place : places) {
      e_.push(between(-1 - place));
      square += e_.back() * e_.back();
    }
    for (double& e : e_) e /= elementary::sqrt(square);
  }

  /// Whether e·ė = 0 follows from them.
  constexpr bool keep_the_norm() {
    sequence<sequence<double>> rows(m_.kinematics.size());
    const sequence<double> rest = with_rate(none);
    for (int place : places_) {
      const sequence<double> moving = with_rate(place);
      for (int i = 0; i < rows.size(); ++i) rows[i].push(moving[i] - rest[i]);
    }
    row_space kept;
    for (int i = 0; i < rows.size(); ++i) {
      bool holds_a_rate = false;
      for (double entry : rows[i]) holds_a_rate = holds_a_rate || !numeric::equal(entry, 0.0);
      rows[i].push(rest[i]);
      if (holds_a_rate) kept.add(rows[i]);
    }
    sequence<double> norm = e_;
    norm.push(0);
    return !kept.add(norm);
  }

private:
  static constexpr sequence<int> nodes_of(const mechanism& m) {
    sequence<int> nodes;
    for (const expression& e : m.kinematics) nodes.push(e.node());
    return nodes;
  }

  /// From 0.5 to 1.5, by a number of one's own (Marsaglia's xorshift).
  static constexpr double between(int number) {
    std::uint64_t random = 88172645463325252u + 2654435761u * static_cast<std::uint64_t>(number);
    for (int i = 0; i < 3; ++i) random ^= random << 13, random ^= random >> 7, random ^= random << 17;
    return 0.5 + static_cast<double>(random >> 11) / 9007199254740992.0;
  }

  /// What the equations leave where one rate of the quaternion is 1, or none.
  constexpr sequence<double> with_rate(int moving) {
    evaluate_.at([&](int id) {
      for (int i = 0; i < places_.size(); ++i) {
        if (m_.coordinates[places_[i]].node() == id) return e_[i];
        if (m_.coordinate_rates[places_[i]].node() == id) return places_[i] == moving ? 1.0 : 0.0;
      }
      return between(id);
    });
    sequence<double> left;
    for (const expression& e : m_.kinematics) left.push(evaluate_[e.node()]);
    return left;
  }

  const mechanism& m_;
  const sequence<int>& places_;
  symbolic::evaluation evaluate_;
  sequence<double> e_{};
};

} // namespace detail

/// The coordinates of each such quaternion, by their places. A quaternion of other expressions than
/// coordinates, or whose norm other equations have to keep, is not among them.
constexpr sequence<sequence<int>> unit_quaternions(const mechanism& m) {
  sequence<sequence<int>> found;
  sequence<char> taken(m.coordinates.size(), 0);
  for (const frame& f : m.frames) {
    const sequence<int> places = detail::coordinates_of_quaternion(m, f);
    bool is_new = places.size() > 1;
    for (int place : places) is_new = is_new && taken[place] == 0;
    if (!is_new || !detail::kinematics_at_numbers(m, places).keep_the_norm()) continue;
    for (int place : places) taken[place] = 1;
    found.push(places);
  }
  return found;
}

} // namespace kanexpr::mechanics
