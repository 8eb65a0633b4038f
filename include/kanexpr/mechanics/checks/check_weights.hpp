#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/summands.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Gravity given as a weight, and weights listed in addition to gravity.
namespace kanexpr::mechanics {

namespace detail {

/// Finds weights among the loads, as summands and along any axes. Loads that contain the symbols of the mass
/// and of gravity are evaluated at one generic state: the summands of a force at the mass center, and the
/// rates of the summands of a potential energy.
class weights_checker {
public:
  constexpr weights_checker(const mechanism& m, const loads& acting, const contents& held, load_check& by)
      : m_(m), acting_(acting), held_(held), by_(by), of_gravity_(constants_in(acting.gravity)) {}

  constexpr void run() {
    for (const body& b : m_.bodies) check_gravity(b);
    if (by_.mistake()) return;
    for (const body& b : m_.bodies) collect(b);
    if (candidates_.empty()) return;
    generic_motion motion(m_, held_, wanted());
    if (!(motion.find_state() || motion.move_freely()) || !motion.is_defined(acting_.gravity)) return;
    for (const candidate& c : candidates_)
      if (motion.is_defined(c.on->mass)) check_candidate(c, motion);
  }

private:
  using kind = contents::kind;

  /// A force or a potential energy that may contain the weight of a body.
  struct candidate {
    const body* on = nullptr;
    const force* by_force = nullptr;
    int energy = none; ///< index among the potential energies
  };

  template <class Value>
  constexpr sequence<int> constants_in(const Value& v) const {
    return held_.symbols_in(v, {kind::parameter, kind::input});
  }

  constexpr void check_gravity(const body& b) {
    const sequence<int> of_mass = constants_in(b.mass);
    if (of_mass.empty() || !of_gravity_.contains_all(of_mass)) return;
    const bool is_mass = of_mass[0] == b.mass.node();
    by_.fail({"gravity contains ", m_.g->symbol_at(of_mass[0]).called.view(),
              is_mass ? ", the mass of " : ", as does the mass of ", b.called.view(),
              "; it must be the free-fall acceleration, not a weight"});
  }

  constexpr void collect(const body& b) {
    const sequence<int> of_mass = constants_in(b.mass);
    const auto may_contain_weight = [&](const auto& value) {
      const sequence<int> constants = constants_in(value);
      return constants.contains_all(of_mass) && constants.contains_all(of_gravity_);
    };
    for (const force& f : acting_.forces)
      if ((f.point == b.center || f.against == b.center) && may_contain_weight(f.value))
        candidates_.push({&b, &f, none});
    for (int i = 0; i < acting_.potential_energies.size(); ++i)
      if (may_contain_weight(acting_.potential_energies[i].value)) candidates_.push({&b, nullptr, i});
  }

  constexpr sequence<expression> wanted() const {
    sequence<expression> all;
    const auto push = [&](expression e) { all.push(e); };
    acting_.gravity.each_entry(push);
    for (const point& p : m_.points) p.offset.each_entry(push);
    for (const candidate& c : candidates_) {
      push(c.on->mass);
      if (c.by_force != nullptr)
        c.by_force->value.each_entry(push);
      else
        push(acting_.potential_energies[c.energy].value);
    }
    return all;
  }

  constexpr void check_candidate(const candidate& c, const generic_motion& motion) {
    const body& b = *c.on;
    const triple weight = motion[b.mass].value * motion.vector_of(acting_.gravity);
    sequence<triple> summands;
    if (c.by_force == nullptr) {
      if (!is_position_defined(b.center, motion)) return;
      for (const summand& s : summands_of(acting_.potential_energies[c.energy].value, b, motion))
        add(summands, s.value.rate, {1, 0, 0});
      if (is_sum_of_some(summands, {-dot(weight, velocity(b.center, motion)), 0, 0}))
        by_.fail({"potential energy ", base::counted(c.energy + 1).view(), " contains that of the weight of ",
                  b.called.view(), ", which gravity already applies"});
      return;
    }
    const force& f = *c.by_force;
    for (const vector::part& p : f.value.parts)
      for (int i = 0; i < 3; ++i)
        for (const summand& s : summands_of(p.value[i], b, motion))
          add(summands, s.value.value, motion.basis(p.frame)[i]);
    if (!is_sum_of_some(summands, (f.point == b.center ? 1.0 : -1.0) * weight)) return;
    const bool is_whole = f.against == none && (f.value - b.mass * acting_.gravity).is_zero();
    by_.fail({"the force ", by_.place_of(f).view(), is_whole ? " is" : " contains", " the weight of ",
              b.called.view(), ", which gravity already applies"});
  }

  /// The summands that may be part of the weight; all of them if the mass contains no symbols.
  constexpr sequence<summand> summands_of(expression e, const body& b, const generic_motion& motion) const {
    const sequence<int> of_mass = constants_in(b.mass);
    sequence<summand> found;
    for (const summand& s : summand_expansion(motion, *m_.g, of_mass)(e))
      if (s.is_of_mass || of_mass.empty()) found.push(s);
    return found;
  }
  static constexpr void add(sequence<triple>& all, double size, triple along) {
    if (numeric::elementary::detail::is_finite(size) && !base::equal(size, 0.0)) all.push(size * along);
  }

  constexpr bool is_position_defined(int place, const generic_motion& motion) const {
    for (int p = place; p != none; p = m_.points[p].parent)
      if (!motion.is_defined(m_.points[p].offset)) return false;
    return true;
  }
  /// The rate of the position.
  constexpr triple velocity(int place, const generic_motion& motion) const {
    triple sum;
    for (int p = place; p != none; p = m_.points[p].parent)
      sum = sum + motion.rate_of(m_.points[p].offset, &generic_motion::by_orientation);
    return sum;
  }

  const mechanism& m_;
  const loads& acting_;
  const contents& held_;
  load_check& by_;
  sequence<int> of_gravity_;
  sequence<candidate> candidates_{};
};

} // namespace detail

constexpr void check_weights(const mechanism& m, const loads& acting, const contents& held, load_check& by) {
  if (acting.has_gravity) detail::weights_checker(m, acting, held, by).run();
}

} // namespace kanexpr::mechanics
