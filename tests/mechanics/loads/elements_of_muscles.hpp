// The rows of elements for muscles, active and passive ones.
#pragma once

#include "arm.hpp"
#include "element.hpp"
#include "elements.hpp"

#include <kanexpr/numeric/muscle_curves.hpp>
#include <kanexpr/runtime/building/block_data.hpp>

#include <cmath>

namespace elements {

using kanexpr::muscle_formulation;

/// The parameters of the muscles of the table, and what they store.
struct muscle_of_table {
  static constexpr double peak = 3, fiber = 0.8, slack = 0.4, pennation = 0.3, strain = 0.6, passive = 3;

  static kanexpr::runtime::muscle_data data(muscle_formulation by, bool is_active) {
    return {.peak_isometric_force = peak,
            .optimal_fiber_length = fiber,
            .tendon_slack_length = slack,
            .maximal_fiber_velocity = 2.0,
            .pennation = pennation,
            .fiber_damping = 0.5,
            .tendon_strain = strain,
            .passive_strain = passive,
            .has_activation_dynamics = is_active,
            .formulation = by};
  }

  /// The length of the fibers over a projected length.
  template <class Number>
  static Number fibers_over(const Number& projected) {
    const double width = fiber * std::sin(pennation);
    return sqrt(projected * projected + width * width);
  }
  /// The projected length of fibers with a relative length.
  template <class Number>
  static Number projected(const Number& relative) {
    const double width = std::sin(pennation);
    return fiber * sqrt(relative * relative - width * width);
  }
  /// The integrals of the passive force over the length of the fibers and of the force of the tendon over its
  /// length.
  static expression energy_of_fibers(const expression& length) {
    const expression relative = length / fiber;
    return peak * fiber / (std::exp(4) - 1) * (passive / 4 * exp(4 / passive * (relative - 1)) - relative);
  }
  static expression energy_of_tendon(const expression& length) {
    const double factor = kanexpr::numeric::muscle_curves::tendon_factor(strain);
    const expression relative = length / slack;
    return peak * slack * (0.2 / factor * exp(factor * (relative - 0.995)) - 0.25 * relative);
  }
};

/// A muscle is measured by the length of its pathway, its rate, and its state variables, of which the
/// activation is the first.
inline element muscle_along(std::size_t path, muscle_formulation by, bool is_active) {
  using enum muscle_formulation;
  using known = muscle_of_table;
  const char* const called = by == rigid_tendon   ? "muscle with a rigid tendon"
                             : by == tendon_force ? "muscle with the force of its tendon"
                                                  : "muscle with the length of its fibers";
  element e{std::string(is_active ? "active " : "passive ") + called + ": " +
                mechanisms::arm().pathways()[path].first,
            is_active ? nature::driven : nature::dissipative,
            {},
            {},
            [by, is_active](VectorXd& x) { // to positive activations, forces and lengths
              if (is_active) x(8) = 0.5 + 0.4 * x(8);
              if (by != rigid_tendon)
                x(x.size() - 1) = (by == tendon_force ? 0.4 : 1.1) + 0.25 * x(x.size() - 1);
            }};
  e.build = [path, by, is_active] {
    mechanisms::arm b;
    const pathway along = b.pathways()[path].second;
    const auto states = b.muscle("M", along, b.number(is_active ? 0.7 : 0.0), known::data(by, is_active));
    mechanics::known_motion moves(b.mechanism());
    const expression length = b.length_of(along);
    mechanism_with_element made{derive(b), {length, moves.moving().rate(length)}, {}};
    if (is_active) made.measured.push_back(states.activation);
    if (by != rigid_tendon) made.measured.push_back(states.tendon_state);
    if (is_active) return made;
    expression tendon = b.number(known::slack);
    if (by == tendon_force)
      tendon = known::slack *
               kanexpr::numeric::muscle_curves::tendon_length(states.tendon_state, b.number(known::strain));
    if (by == fiber_length) tendon = length - known::projected(states.tendon_state);
    made.stored = known::energy_of_fibers(known::fibers_over(expression(length - tendon)));
    if (by != rigid_tendon) made.stored += known::energy_of_tendon(tendon);
    return made;
  };
  e.power = [by, is_active](const VectorXd& m) {
    namespace curves = kanexpr::numeric::muscle_curves;
    const double state = m(m.size() - 1);
    double force = state;
    if (by == fiber_length)
      force = curves::tendon_force((m(0) - known::projected(state)) / known::slack, known::strain);
    if (by == rigid_tendon) {
      const double projected = m(0) - known::slack, length = known::fibers_over(projected),
                   cosine = projected / length, relative = length / known::fiber,
                   velocity = m(1) * cosine / (2 * known::fiber), activation = is_active ? m(2) : 0;
      force = cosine * (activation * curves::active_force(relative) * curves::velocity_force(velocity) +
                        curves::passive_force(relative, known::passive) + 0.5 * velocity);
    }
    return -known::peak * force * m(1);
  };
  return e;
}

inline std::vector<element> of_muscles() {
  using enum muscle_formulation;
  std::vector<element> all;
  for (const muscle_formulation by : {rigid_tendon, tendon_force, fiber_length})
    for (const bool is_active : {true, false})
      for (const std::size_t path : {0UL, 4UL}) all.push_back(muscle_along(path, by, is_active));
  return all;
}

} // namespace elements
