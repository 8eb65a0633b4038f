#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// Loads that are listed twice.
namespace kanexpr::mechanics {

namespace detail {

class repeated_loads_checker {
public:
  constexpr repeated_loads_checker(const mechanism& m, const loads& acting, const contents& held,
                                   load_check& by)
      : m_(m), acting_(acting), held_(held), by_(by) {}

  constexpr void run();

private:
  using kind = contents::kind;

  /// The points or frames on which a load acts.
  struct ends {
    int on = none;
    int against = none;
    int sign = 1; ///< −1: the load acts opposite to the written one

    constexpr bool is_pair(const ends& other) const {
      return (on == other.on && against == other.against) || (on == other.against && against == other.on);
    }
  };
  template <class Load>
  static constexpr ends ends_of(const Load& l) {
    if constexpr (requires { l.point; })
      return {l.point, l.against};
    else
      return {l.frame, l.against};
  }

  /// Two loads that contain the same symbols: vectors along axes that turn relative to each other, or
  /// energies.
  struct candidate {
    const vector* vectors[2]{};
    expression energies[2]{};
    int sign = 1;
    sentence mistake{};
  };

  constexpr bool is_at_rest(const force&, int p) const {
    for (; p != none; p = m_.points[p].parent) {
      if (m_.points[p].has_declared_velocity()) return false;
      for (const vector::part& part : m_.points[p].offset.parts)
        if (part.frame != mechanism::inertial || !held_.is_fixed(part.value)) return false;
    }
    return true;
  }
  constexpr bool is_at_rest(const torque&, int f) const { return f == mechanism::inertial; }

  /// The ends of a load except one that is at rest.
  template <class Load>
  constexpr ends moving_ends_of(const Load& l) const {
    const auto [on, against, sign] = ends_of(l);
    if (against == none || is_at_rest(l, against)) return {on, none};
    if (is_at_rest(l, on)) return {against, none, -1};
    return {on, against};
  }

  template <class Load>
  constexpr void check_pairs(const sequence<Load>& all) {
    for (int i = 1; i < all.size(); ++i)
      for (int j = 0; j < i && !by_.mistake(); ++j)
        if (const int sign = relative_sign(all[i], all[j]); sign != 0) compare(all[i], all[j], sign);
  }

  /// The sign with which two loads have the same effect if their vectors agree; 0 if they act on different
  /// ends.
  template <class Load>
  constexpr int relative_sign(const Load& one, const Load& other) const {
    const ends a = moving_ends_of(one), b = moving_ends_of(other);
    const int sign = a.sign * b.sign;
    if (a.on == b.on && a.against == b.against) return sign;
    if (a.against != none && a.is_pair(b)) return -sign;
    // the torque of a motor between two frames must not be listed as an external load as well
    const bool is_external = a.against == none;
    if (is_external == (b.against == none) || held_.symbols_in(one.value, {kind::input}).empty()) return 0;
    const ends &external = is_external ? a : b, &between = is_external ? b : a;
    return external.on == between.on ? sign : external.on == between.against ? -sign : 0;
  }

  template <class Load>
  constexpr void compare(const Load& one, const Load& other, int sign) {
    if (one.value.is_zero() || other.value.is_zero()) return;
    if ((sign < 0 ? one.value + other.value : one.value - other.value).is_zero())
      by_.fail({sentence_for(one, other).view()});
    else if (contain_same(one.value, other.value, {kind::parameter, kind::input, kind::speed}))
      candidates_.push({{&one.value, &other.value}, {}, sign, sentence_for(one, other)});
  }
  template <class Value>
  constexpr bool contain_same(const Value& a, const Value& b, std::initializer_list<kind> kinds) const {
    const sequence<int> in_a = held_.symbols_in(a, kinds), in_b = held_.symbols_in(b, kinds);
    return in_a.size() == in_b.size() && in_b.contains_all(in_a);
  }

  constexpr void check_energies() {
    const sequence<given_potential_energy>& all = acting_.potential_energies;
    for (int i = 0; i < all.size(); ++i)
      for (int j = 0; j < i && !by_.mistake(); ++j) {
        const expression one = all[i].value, other = all[j].value;
        if (one.is_constant()) continue; // no effect, such as a spring without stiffness
        const sentence mistake({"potential energy ", base::counted(i + 1).view(),
                                " repeats potential energy ", base::counted(j + 1).view()});
        if (one == other)
          by_.fail({mistake.view()});
        else if (contain_same(one, other, {kind::coordinate, kind::parameter, kind::input}))
          candidates_.push({{}, {one, other}, 1, mistake});
      }
  }

  constexpr void check_candidates() {
    if (candidates_.empty() || by_.mistake()) return;
    sequence<expression> all;
    for (const candidate& c : candidates_)
      for (int i = 0; i < 2; ++i)
        if (c.vectors[i] == nullptr)
          all.push(c.energies[i]);
        else
          c.vectors[i]->each_entry([&](expression e) { all.push(e); });
    generic_motion motion(m_, held_, all);
    if (!motion.find_state() && !motion.move_freely()) return;
    for (const candidate& c : candidates_)
      if (have_same_value(c, motion)) by_.fail({c.mistake.view()});
  }
  static constexpr bool have_same_value(const candidate& c, const generic_motion& motion) {
    triple values[2];
    for (int i = 0; i < 2; ++i) {
      const vector* const v = c.vectors[i];
      if (v == nullptr ? !motion.is_defined(c.energies[i]) : !motion.is_defined(*v)) return false;
      // energies are equal if they differ by a constant
      values[i] = v == nullptr ? triple{motion[c.energies[i]].rate, 0, 0} : motion.vector_of(*v);
    }
    const double size = length(values[0]);
    return size > 0 && length(values[0] - c.sign * values[1]) <= 1e-10 * size;
  }

  static constexpr std::string_view noun(const force&) { return "the force "; }
  static constexpr std::string_view noun(const torque&) { return "the torque "; }
  template <class Load>
  constexpr sentence sentence_for(const Load& one, const Load& other) const {
    const sentence before = by_.place_of(other);
    if (ends_of(one).is_pair(ends_of(other)))
      return sentence({noun(other), before.view(), " is listed twice"});
    return sentence({noun(one), by_.place_of(one).view(), " repeats ", noun(other), before.view()});
  }

  /// Springs or dampers between the same two points or frames.
  template <class Load, class Same>
  constexpr void check_same(const sequence<Load>& all, std::string_view what, const Same& is_same) {
    for (int i = 0; i < all.size(); ++i)
      for (int j = 0; j < i; ++j)
        if (ends_of(all[i]).is_pair(ends_of(all[j])) && is_same(all[i], all[j]))
          by_.fail({"the ", what, by_.ends_of(all[j]).view(), " is listed twice"});
  }

  const mechanism& m_;
  const loads& acting_;
  const contents& held_;
  load_check& by_;
  sequence<candidate> candidates_{};
};

/// Defined after the templates it uses, which clang++ must have parsed already.
constexpr void repeated_loads_checker::run() {
  check_pairs(acting_.forces);
  check_pairs(acting_.torques);
  check_energies();
  check_candidates();
  using spring = spring_damper;
  check_same(acting_.spring_dampers, "spring between ", [](const spring& a, const spring& b) {
    return !a.stiffness.is_zero() && a.stiffness == b.stiffness && a.length == b.length;
  });
  check_same(acting_.spring_dampers, "damper between ",
             [](const spring& a, const spring& b) { return !a.damping.is_zero() && a.damping == b.damping; });
  check_same(acting_.torsional_dampers, "torsional damper between ",
             [](const torsional_damper& a, const torsional_damper& b) { return a.damping == b.damping; });
}

} // namespace detail

constexpr void check_repeated_loads(const mechanism& m, const loads& acting, const contents& held,
                                    load_check& by) {
  detail::repeated_loads_checker(m, acting, held, by).run();
}

} // namespace kanexpr::mechanics
