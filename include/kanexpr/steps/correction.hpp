#pragma once

#include <kanexpr/compiled/equations_of_motion.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/steps/unit_quaternions.hpp>

#include <array>

namespace kanexpr::compiled {

/// One cost after another, so many times.
constexpr symbolic::cost added(symbolic::cost total, const symbolic::cost& c, int times = 1) {
  total.multiplications += times * c.multiplications;
  total.additions += times * c.additions;
  total.divisions += times * c.divisions;
  total.trigonometric += times * c.trigonometric;
  total.other += times * c.other;
  total.nodes += times * c.nodes;
  return total;
}

/// Brings a state that nearly satisfies its constraints back to them, in an amount of work that is known
/// beforehand: quaternions get norm 1, then come some steps of Newton's method for the dependent coordinates,
/// then the dependent speeds. What is independent stays.
template <class System, int newton_steps>
class correction {
  static constexpr const deriving::survey& known = survey_of<System>;
  static constexpr int unknowns = known.configuration_constraints;
  using eom = equations_of_motion<System>;
  using quantity = mechanics::quantity;
  using quaternions = unit_quaternions<System>;

public:
  static constexpr bool is_needed = newton_steps > 0 && (known.constraints > 0 || quaternions::count > 0);

  template <class Time, class T, class P, class R>
  static kanexpr::status apply(const Time& t, state<System, T>& x, const P& p, const R& r) {
    if (const kanexpr::status s = quaternions::normalize(x, near_one); !s) return s;
    if constexpr (unknowns > 0)
      for (int done = 0; done < newton_steps; ++done) {
        if (const kanexpr::status s = step(t, x, p, r); !s) return s;
        if constexpr (quaternions::are_bound)
          if (const kanexpr::status s = quaternions::normalize(x, near_one); !s) return s;
      }
    if constexpr (known.constraints > 0) {
      const auto u = out_of_line<function<System, quantity::dependent_speeds>>{}(t, x, p, r);
      for (int i = 0; i < known.constraints; ++i) x(place(unknowns + i)) = u(i);
      return status_of(u);
    }
    return {};
  }

  /// A norm beyond this is no trace that a step leaves.
  static constexpr lower::norm_range near_one{0.5, 2};

  /// Where a dependent coordinate, or after them a dependent speed, stands in the state.
  static constexpr int place(int i) { return places[static_cast<std::size_t>(i)]; }

  /// Operations of all evaluations and solutions.
  static constexpr symbolic::cost cost() {
    symbolic::cost total;
    if constexpr (is_needed) total = added(total, quaternions::cost());
    if constexpr (is_needed && known.constraints > 0) total = added(total, eom::dependent_speeds.cost());
    if constexpr (is_needed && unknowns > 0) {
      symbolic::cost one = eom::configuration_step.cost();
      if constexpr (quaternions::are_bound) one = added(one, quaternions::cost());
      total = added(total, one, newton_steps);
    }
    return total;
  }

private:
  template <class Time, class T, class P, class R>
  static kanexpr::status step(const Time& t, state<System, T>& x, const P& p, const R& r) {
    const auto change = out_of_line<function<System, quantity::configuration_step>>{}(t, x, p, r);
    if (status_of(change))
      for (int i = 0; i < unknowns; ++i) x(place(i)) = T(x(place(i)) + change(i));
    return status_of(change);
  }

  static constexpr auto places = [] {
    std::array<int, static_cast<std::size_t>(unknowns + known.constraints + 1)> found{};
    std::size_t next = 0;
    for (int i = 0; i < known.coordinates + known.speeds; ++i)
      if (known.dependent[i]) found[next++] = i;
    return found;
  }();
};

} // namespace kanexpr::compiled
