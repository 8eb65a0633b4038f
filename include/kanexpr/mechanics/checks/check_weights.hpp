#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/summands.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Gravity given as a weight, and weights listed in addition to gravity.
namespace kanexpr::mechanics {

namespace detail {

/// Finds weights among the loads, even as summands of other loads and along arbitrary axes. Loads that
/// contain the symbols of the mass and of gravity are evaluated at one generic state: the summands of a force
/// at the mass center, and the rates of the summands of a potential energy.
class weights_checker {
public:
  constexpr weights_checker(const mechanism& m, const loads& given, const contents& held, load_check& by)
      : m_(m), loads_(given), held_(held), by_(by), of_gravity_(constants_in(given.gravity)) {}

  constexpr void run();

private:
  using kind = contents::kind;

  constexpr sequence<int> constants_in(expression e) const {
    return held_.symbols_in(e, {kind::parameter, kind::input});
  }
  constexpr sequence<int> constants_in(const vector& v) const {
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

  /// Calls `visit(body, load, place)` for each force and potential energy that may contain the weight of a
  /// body.
  template <class Visit>
  constexpr void each_load(const Visit& visit) const {
    for (const body& b : m_.bodies) {
      const sequence<int> of_mass = constants_in(b.mass);
      const auto may_contain_weight = [&](const auto& value) {
        const sequence<int> constants = constants_in(value);
        return constants.contains_all(of_mass) && constants.contains_all(of_gravity_);
      };
      for (const force& f : loads_.forces)
        if ((f.point == b.center || f.against == b.center) && may_contain_weight(f.value)) visit(b, f, none);
      for (int i = 0; i < loads_.potential_energies.size(); ++i)
        if (may_contain_weight(loads_.potential_energies[i].value)) visit(b, loads_.potential_energies[i], i);
    }
  }

  constexpr triple weight_of(const generic_motion& motion, const body& b) const {
    return motion[b.mass].value * motion.vector_of(loads_.gravity);
  }
  constexpr void check_load(const generic_motion& motion, const body& b, const given_potential_energy& load,
                            int place) const {
    triple velocity;
    for (int p = b.center; p != none; p = m_.points[p].parent) {
      if (!motion.is_defined(m_.points[p].offset)) return;
      velocity = velocity + motion.rate_of(m_.points[p].offset, &generic_motion::by_orientation);
    }
    sequence<triple> summands;
    for (const summand& s : summands_of(load.value, b, motion)) add(summands, s.value.rate, {1, 0, 0});
    if (is_sum_of_some(summands, {-dot(weight_of(motion, b), velocity), 0, 0}))
      by_.fail({"potential energy ", base::counted(place + 1).view(),
                " includes the energy of the weight of ", b.called.view(),
                ", which gravity already applies"});
  }
  constexpr void check_load(const generic_motion& motion, const body& b, const force& f, int) const {
    sequence<triple> summands;
    for (const vector::part& p : f.value.parts)
      for (int i = 0; i < 3; ++i)
        for (const summand& s : summands_of(p.value[i], b, motion))
          add(summands, s.value.value, motion.basis(p.frame)[i]);
    if (!is_sum_of_some(summands, (f.point == b.center ? 1.0 : -1.0) * weight_of(motion, b))) return;
    const bool is_whole = f.against == none && (f.value - b.mass * loads_.gravity).is_zero();
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

  const mechanism& m_;
  const loads& loads_;
  const contents& held_;
  load_check& by_;
  sequence<int> of_gravity_;
};

/// Defined after the templates it uses, which clang++ must have parsed already.
constexpr void weights_checker::run() {
  sequence<expression> wanted;
  for (const body& b : m_.bodies) check_gravity(b);
  each_load([&](const body& b, const auto& load, int) {
    push_entries(wanted, b.mass), push_entries(wanted, load.value);
  });
  if (by_.mistake() || wanted.empty()) return;
  push_entries(wanted, loads_.gravity);
  for (const point& p : m_.points) push_entries(wanted, p.offset);
  generic_motion motion(m_, held_, wanted);
  if (!(motion.find_state() || motion.move_freely()) || !motion.is_defined(loads_.gravity)) return;
  each_load([&](const body& b, const auto& load, int place) {
    if (motion.is_defined(b.mass)) check_load(motion, b, load, place);
  });
}

} // namespace detail

constexpr void check_weights(const mechanism& m, const loads& given, const contents& held, load_check& by) {
  if (given.has_gravity) detail::weights_checker(m, given, held, by).run();
}

} // namespace kanexpr::mechanics
