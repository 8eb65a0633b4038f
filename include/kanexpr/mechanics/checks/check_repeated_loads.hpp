#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>
#include <type_traits>

/// Loads that are listed twice.
namespace kanexpr::mechanics {

namespace detail {

/// Compares loads that act on the same points or frames and contain the same symbols: symbolically and,
/// because they may be written in different ways, at a generic state.
class repeated_loads_checker {
public:
  constexpr repeated_loads_checker(const mechanism& m, const loads& given, const contents& held,
                                   load_check& by)
      : m_(m), loads_(given), held_(held), by_(by) {}

  constexpr void run();

private:
  using kind = contents::kind;

  /// The points or frames on which a load acts, in ascending order.
  struct ends {
    int on = none;
    int against = none;
    int sign = 1; ///< −1 if the ends are swapped, so that the load acts in the opposite sense

    constexpr bool is_same(const ends& other) const { return on == other.on && against == other.against; }
  };
  template <class Load>
  static constexpr ends ends_of(const Load& l) {
    int on = none;
    if constexpr (requires { l.point; })
      on = l.point;
    else
      on = l.frame;
    return l.against == none || on < l.against ? ends{on, l.against, 1} : ends{l.against, on, -1};
  }
  /// The ends of a load, without an end that is at rest.
  template <class Load>
  constexpr ends moving_ends_of(const Load& l) const {
    const ends all = ends_of(l);
    if (all.against == none || is_at_rest(l, all.against)) return {all.on, none, all.sign};
    if (is_at_rest(l, all.on)) return {all.against, none, -all.sign};
    return all;
  }
  constexpr bool is_at_rest(const force&, int p) const {
    for (; p != none; p = m_.points[p].parent) {
      if (m_.points[p].has_declared_velocity()) return false;
      for (const vector::part& part : m_.points[p].offset.parts)
        if (part.frame != mechanism::inertial || !held_.is_fixed(part.value)) return false;
    }
    return true;
  }
  constexpr bool is_at_rest(const torque&, int f) const { return f == mechanism::inertial; }

  /// The sign with which two loads have the same effect if their values agree; 0 if they act on different
  /// ends.
  template <class Load>
  constexpr int relative_sign(const Load& one, const Load& other) const {
    const ends a = moving_ends_of(one), b = moving_ends_of(other);
    const int sign = a.sign * b.sign;
    if (a.is_same(b)) return sign;
    // the torque of a motor between two frames must not be listed as an external load as well
    const bool is_external = a.against == none;
    if (is_external == (b.against == none) || held_.symbols_in(one.value, {kind::input}).empty()) return 0;
    const ends &external = is_external ? a : b, &between = is_external ? b : a;
    return external.on == between.on ? sign : external.on == between.against ? -sign : 0;
  }
  constexpr int relative_sign(const given_potential_energy&, const given_potential_energy&) const {
    return 1;
  }

  /// Whether a load has no effect, such as the energy of a spring without stiffness.
  static constexpr bool has_no_effect(const vector& v) { return v.is_zero(); }
  static constexpr bool has_no_effect(expression energy) { return energy.is_constant(); }

  static constexpr bool are_equal(const vector& a, const vector& b, int sign) {
    vector difference = a;
    if (sign < 0)
      difference.add(b);
    else
      difference.subtract(b);
    return difference.is_zero();
  }
  static constexpr bool are_equal(expression a, expression b, int) { return a == b; }

  template <class Value>
  constexpr bool contain_same_symbols(const Value& a, const Value& b) const {
    constexpr kind varying = std::is_same_v<Value, vector> ? kind::speed : kind::coordinate;
    const sequence<int> in_a = held_.symbols_in(a, {varying, kind::parameter, kind::input}),
                        in_b = held_.symbols_in(b, {varying, kind::parameter, kind::input});
    return in_a.size() == in_b.size() && in_b.contains_all(in_a);
  }

  /// The value of a vector, or the rate of an energy, because energies are equal if they differ by a
  /// constant.
  static constexpr triple value_at(const generic_motion& motion, const vector& v) {
    return motion.vector_of(v);
  }
  static constexpr triple value_at(const generic_motion& motion, expression energy) {
    return {motion[energy].rate, 0, 0};
  }
  template <class Value>
  static constexpr bool have_same_value(const generic_motion& motion, const Value& one, const Value& other,
                                        int sign) {
    if (!motion.is_defined(one) || !motion.is_defined(other)) return false;
    const triple a = value_at(motion, one), b = value_at(motion, other);
    return length(a) > 0 && length(a - sign * b) <= 1e-10 * length(a);
  }

  /// Calls `visit(all, i, j, sign)` for each pair of loads on the same ends.
  template <class Visit>
  constexpr void each_pair(const Visit& visit) const {
    const auto each_pair_of = [&](const auto& all) {
      for (int i = 1; i < all.size(); ++i)
        for (int j = 0; j < i && !by_.mistake(); ++j) {
          if (has_no_effect(all[i].value) || has_no_effect(all[j].value)) continue;
          if (const int sign = relative_sign(all[i], all[j]); sign != 0) visit(all, i, j, sign);
        }
    };
    each_pair_of(loads_.forces), each_pair_of(loads_.torques), each_pair_of(loads_.potential_energies);
  }

  static constexpr std::string_view noun(const force&) { return "the force "; }
  static constexpr std::string_view noun(const torque&) { return "the torque "; }
  template <class Load>
  constexpr void fail(const sequence<Load>& all, int i, int j) const {
    const sentence before = by_.place_of(all[j]);
    if (ends_of(all[i]).is_same(ends_of(all[j])))
      by_.fail({noun(all[j]), before.view(), " is listed twice"});
    else
      by_.fail({noun(all[i]), by_.place_of(all[i]).view(), " repeats ", noun(all[j]), before.view()});
  }
  constexpr void fail(const sequence<given_potential_energy>&, int i, int j) const {
    by_.fail({"potential energy ", base::counted(i + 1).view(), " repeats potential energy ",
              base::counted(j + 1).view()});
  }

  /// Springs or dampers between the same two points or frames.
  template <class Load, class Same>
  constexpr void check_same(const sequence<Load>& all, std::string_view what, const Same& is_same) const {
    for (int i = 0; i < all.size(); ++i)
      for (int j = 0; j < i; ++j)
        if (ends_of(all[i]).is_same(ends_of(all[j])) && is_same(all[i], all[j]))
          by_.fail({"the ", what, by_.ends_of(all[j]).view(), " is listed twice"});
  }

  const mechanism& m_;
  const loads& loads_;
  const contents& held_;
  load_check& by_;
};

/// Defined after the templates it uses, which clang++ must have parsed already.
constexpr void repeated_loads_checker::run() {
  using spring = spring_damper;
  check_same(loads_.spring_dampers, "spring between ", [](const spring& a, const spring& b) {
    return !a.stiffness.is_zero() && a.stiffness == b.stiffness && a.length == b.length;
  });
  check_same(loads_.spring_dampers, "damper between ",
             [](const spring& a, const spring& b) { return !a.damping.is_zero() && a.damping == b.damping; });
  check_same(loads_.torsional_dampers, "torsional damper between ",
             [](const torsional_damper& a, const torsional_damper& b) { return a.damping == b.damping; });
  sequence<expression> compared;
  each_pair([&](const auto& all, int i, int j, int sign) {
    if (are_equal(all[i].value, all[j].value, sign)) return fail(all, i, j);
    if (contain_same_symbols(all[i].value, all[j].value))
      push_entries(compared, all[i].value), push_entries(compared, all[j].value);
  });
  if (by_.mistake() || compared.empty()) return;
  generic_motion motion(m_, held_, compared);
  if (!motion.find_state() && !motion.move_freely()) return;
  each_pair([&](const auto& all, int i, int j, int sign) {
    if (contain_same_symbols(all[i].value, all[j].value) &&
        have_same_value(motion, all[i].value, all[j].value, sign))
      fail(all, i, j);
  });
}

} // namespace detail

constexpr void check_repeated_loads(const mechanism& m, const loads& given, const contents& held,
                                    load_check& by) {
  detail::repeated_loads_checker(m, given, held, by).run();
}

} // namespace kanexpr::mechanics
