#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// The quaternions of frames whose unit norm is preserved by the kinematic differential equations. The norm
/// is not a constraint, because it does not restrict the speeds, but numerical integration must maintain it.
namespace kanexpr::mechanics {

namespace detail {

/// The indices of the coordinates in a quaternion; empty if the quaternion has entries other than coordinates
/// and zeros.
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

/// The kinematic differential equations evaluated numerically, with unit quaternions e and generic values of
/// all other symbols.
class kinematics_at_numbers {
public:
  constexpr kinematics_at_numbers(const mechanism& m, const sequence<int>& places)
      : m_(m), places_(places), evaluate_(*m.g, symbolic::nodes_of(m.kinematics)) {
    double square = 0;
    for (int place : places) {
      e_.push(value_of(-1 - place));
      square += e_.back() * e_.back();
    }
    for (double& e : e_) e /= numeric::elementary::sqrt(square);
  }

  /// Whether e·ė = 0 follows from the equations.
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
      for (double entry : rows[i]) holds_a_rate = holds_a_rate || !base::equal(entry, 0.0);
      rows[i].push(rest[i]);
      if (holds_a_rate) kept.add(rows[i]);
    }
    sequence<double> norm = e_;
    norm.push(0);
    return !kept.add(norm);
  }

private:
  /// A random number between 0.5 and 1.5 that depends on `number` only.
  static constexpr double value_of(int number) {
    random_numbers random(88172645463325252u + 2654435761u * static_cast<std::uint64_t>(number));
    random.next(), random.next(); // similar seeds yield similar numbers at first
    return 0.5 + random.next();
  }

  /// The residuals of the equations with one rate of the quaternion, or none, set to 1 and the others to 0.
  constexpr sequence<double> with_rate(int moving) {
    evaluate_.at([&](int id) {
      for (int i = 0; i < places_.size(); ++i) {
        if (m_.coordinates[places_[i]].node() == id) return e_[i];
        if (m_.coordinate_rates[places_[i]].node() == id) return places_[i] == moving ? 1.0 : 0.0;
      }
      return value_of(id);
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

/// The coordinate indices of each quaternion whose norm is preserved. Quaternions that have entries other
/// than coordinates, or whose norm must be preserved by other equations, are not included.
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
