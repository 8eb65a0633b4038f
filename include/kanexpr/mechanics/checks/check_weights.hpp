#pragma once

#include <kanexpr/mechanics/checks/summands.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>

/// Reports gravity given as a weight, and weights listed in addition to gravity.
namespace kanexpr::mechanics {

namespace detail {

/// The parameters and inputs in an expression.
constexpr sequence<int> constants_in(expression e, const contents& held) {
  sequence<int> nodes;
  held.collect(e, contents::kind::parameter, nodes);
  held.collect(e, contents::kind::input, nodes);
  return nodes;
}
constexpr sequence<int> constants_in(const vector& v, const contents& held) {
  sequence<int> nodes;
  for (const vector::part& p : v.parts)
    for (int i = 0; i < 3; ++i)
      for (contents::kind k : {contents::kind::parameter, contents::kind::input})
        held.collect(p.value[i], k, nodes);
  return nodes;
}

constexpr bool are_among(const sequence<int>& some, const sequence<int>& all) {
  for (int node : some)
    if (!all.contains(node)) return false;
  return true;
}

/// Finds weights among the loads, also as summands and along any axes. If loads contain the symbols of the
/// mass and of gravity, the summands of forces at the mass center and the rates of the summands of potential
/// energies are evaluated at one generic state.
class checking_weights {
public:
  constexpr checking_weights(const mechanism& m, const loads& acting, const contents& held, load_check& by)
      : m_(m), acting_(acting), held_(held), by_(by), of_gravity_(constants_in(acting.gravity, held)) {}

  constexpr void run() {
    for (const body& b : m_.bodies) check_gravity(b);
    if (by_.mistake()) return;
    for (int b = 0; b < m_.bodies.size(); ++b) collect(b);
    if (doubtful_.empty()) return;
    generic_motion motion(m_, held_, wanted());
    for (int tries = 0; tries < 6; ++tries) {
      motion.draw();
      if (motion.move(false) || motion.move_freely()) return look_at(motion);
    }
  }

private:
  using kind = contents::kind;

  struct doubt {
    int body = none;
    int force = none;  ///< index among the forces
    double sign = 1;   ///< sign of the force on the body
    int energy = none; ///< index among the potential energies
  };

  constexpr void check_gravity(const body& b) {
    const sequence<int> of_mass = constants_in(b.mass, held_);
    if (of_mass.empty() || !are_among(of_mass, of_gravity_)) return;
    const bool is_mass = of_mass[0] == b.mass.node();
    by_.fail({"gravity contains ", m_.g->symbol_at(of_mass[0]).called.view(),
              is_mass ? ", the mass of " : ", as does the mass of ", b.called.view(),
              "; it must be the free-fall acceleration, not a weight"});
  }

  constexpr void collect(int place) {
    const body& b = m_.bodies[place];
    sequence<int> symbols = constants_in(b.mass, held_);
    for (int node : of_gravity_) symbols.push(node);
    for (int i = 0; i < acting_.forces.size(); ++i) {
      const force& f = acting_.forces[i];
      if ((f.point == b.center || f.against == b.center) && are_among(symbols, constants_in(f.value, held_)))
        doubtful_.push({place, i, f.point == b.center ? 1.0 : -1.0, none});
    }
    for (int i = 0; i < acting_.potential_energies.size(); ++i)
      if (are_among(symbols, constants_in(acting_.potential_energies[i].value, held_)))
        doubtful_.push({place, none, 1, i});
  }

  constexpr sequence<expression> wanted() const {
    sequence<expression> all;
    const auto push = [&](const vector& v) {
      for (const vector::part& p : v.parts)
        for (int i = 0; i < 3; ++i) all.push(p.value[i]);
    };
    push(acting_.gravity);
    for (const point& p : m_.points) push(p.offset);
    for (const doubt& d : doubtful_) {
      all.push(m_.bodies[d.body].mass);
      if (d.force != none)
        push(acting_.forces[d.force].value);
      else
        all.push(acting_.potential_energies[d.energy].value);
    }
    return all;
  }

  constexpr void look_at(const generic_motion& motion) {
    if (!motion.is_defined(acting_.gravity)) return;
    const triple free_fall = motion.vector_of(acting_.gravity);
    for (const doubt& d : doubtful_) {
      const body& b = m_.bodies[d.body];
      if (!motion.is_defined(b.mass)) continue;
      const triple weight = motion[b.mass].value * free_fall;
      if (d.force != none) {
        if (is_sum_of_some(summands_of(acting_.forces[d.force].value, b, motion), d.sign * weight))
          return tell_force(acting_.forces[d.force], b);
      } else {
        if (is_position_defined(b.center, motion) &&
            is_sum_of_some(summands_of(acting_.potential_energies[d.energy].value, b, motion),
                           {-dot(weight, velocity(b.center, motion)), 0, 0}))
          return by_.fail({"potential energy ", counted(d.energy + 1).view(),
                           " contains that of the weight of ", b.called.view(),
                           ", which gravity already applies"});
      }
    }
  }

  constexpr void tell_force(const force& f, const body& b) {
    const bool is_whole = f.against == none && (f.value - b.mass * acting_.gravity).is_zero();
    const sentence where = f.against == none
                               ? sentence({"at ", by_.point(f.point)})
                               : sentence({"between ", by_.both_points(f.point, f.against).view()});
    by_.fail({"the force ", where.view(), is_whole ? " is" : " contains", " the weight of ", b.called.view(),
              ", which gravity already applies"});
  }

  /// The summands of a force. If the mass contains no symbols, every summand may be part of the weight.
  constexpr sequence<triple> summands_of(const vector& v, const body& b, const generic_motion& motion) const {
    const sequence<int> of_mass = constants_in(b.mass, held_);
    const summing_up summands(motion, *m_.g, of_mass);
    sequence<triple> found;
    for (const vector::part& p : v.parts)
      for (int i = 0; i < 3; ++i)
        for (const summand& s : summands(p.value[i]))
          if ((s.is_of_mass || of_mass.empty()) && is_something(s.worth.value))
            found.push(s.worth.value * motion.basis(p.frame)[i]);
    return found;
  }
  /// The summands of the rate of an energy.
  constexpr sequence<triple> summands_of(expression e, const body& b, const generic_motion& motion) const {
    const sequence<int> of_mass = constants_in(b.mass, held_);
    const summing_up summands(motion, *m_.g, of_mass);
    sequence<triple> found;
    for (const summand& s : summands(e))
      if ((s.is_of_mass || of_mass.empty()) && is_something(s.worth.rate)) found.push({s.worth.rate, 0, 0});
    return found;
  }
  static constexpr bool is_something(double x) {
    return elementary::detail::is_finite(x) && !numeric::equal(x, 0.0);
  }

  constexpr bool is_position_defined(int place, const generic_motion& motion) const {
    for (int p = place; p != none; p = m_.points[p].parent)
      if (!motion.is_defined(m_.points[p].offset)) return false;
    return true;
  }
  /// The rate of the position of a point.
  constexpr triple velocity(int place, const generic_motion& motion) const {
    triple sum;
    for (int p = place; p != none; p = m_.points[p].parent)
      for (const vector::part& part : m_.points[p].offset.parts) {
        const triad& axes = motion.basis(part.frame);
        sum = sum + axes * motion.rate(part.value) +
              cross(motion.by_orientation(part.frame), axes * motion.value(part.value));
      }
    return sum;
  }

  const mechanism& m_;
  const loads& acting_;
  const contents& held_;
  load_check& by_;
  sequence<int> of_gravity_;
  sequence<doubt> doubtful_{};
};

} // namespace detail

constexpr void check_weights(const mechanism& m, const loads& acting, const contents& held, load_check& by) {
  if (acting.has_gravity) detail::checking_weights(m, acting, held, by).run();
}

} // namespace kanexpr::mechanics
