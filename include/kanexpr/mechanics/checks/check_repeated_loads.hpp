#pragma once

#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>

/// Loads that are listed twice.
namespace kanexpr::mechanics {

namespace detail {

/// The normal form of a force or torque for comparisons: the point or frame on which it acts, and the one on
/// which its reaction acts, or none if that is at rest.
struct felt {
  int on = none;
  int against = none;
  bool is_turned_round = false; ///< true if it is the opposite of the load as written
};

class checking_repeated_loads {
public:
  constexpr checking_repeated_loads(const mechanism& m, const loads& acting, const contents& held,
                                    load_check& by)
      : m_(m), acting_(acting), held_(held), by_(by) {}

  constexpr void run();

private:
  using kind = contents::kind;

  /// Two loads that contain the same symbols: vectors along axes that turn relative to each other, or
  /// energies.
  struct doubt {
    const vector* one = nullptr;
    const vector* other = nullptr;
    bool is_opposite = false;
    expression energy{}, other_energy{};
    sentence told{};
  };

  static constexpr int place(const force& f) { return f.point; }
  static constexpr int place(const torque& t) { return t.frame; }

  constexpr bool rests(const force&, int p) const {
    for (; p != none; p = m_.points[p].parent) {
      if (m_.points[p].moves_by_declaration()) return false;
      for (const vector::part& part : m_.points[p].offset.parts)
        if (part.frame != mechanism::inertial || !held_.is_fixed(part.value)) return false;
    }
    return true;
  }
  constexpr bool rests(const torque&, int f) const { return f == mechanism::inertial; }

  template <class Load>
  constexpr felt felt_of(const Load& l) const {
    if (l.against == none || rests(l, l.against)) return {place(l), none, false};
    if (rests(l, place(l))) return {l.against, none, true};
    return {place(l), l.against, false};
  }

  template <class Load>
  constexpr void check_pairs(const sequence<Load>& all) {
    for (int i = 1; i < all.size(); ++i)
      for (int j = 0; j < i && !by_.mistake(); ++j) compare(all[i], all[j]);
  }

  template <class Load>
  constexpr void compare(const Load& one, const Load& other) {
    const felt a = felt_of(one), b = felt_of(other);
    const bool is_same_way = a.on == b.on && a.against == b.against;
    const bool is_other_way = a.against != none && a.on == b.against && a.against == b.on;
    if (is_same_way || is_other_way)
      return compare(one, other, (a.is_turned_round != b.is_turned_round) != is_other_way);
    // the torque of a motor between two frames must not also be listed as an external load
    const bool is_outside = a.against == none;
    if (is_outside == (b.against == none) || !holds_input(one.value)) return;
    const felt &outside = is_outside ? a : b, &between = is_outside ? b : a;
    if (outside.on == between.on)
      compare(one, other, a.is_turned_round != b.is_turned_round);
    else if (outside.on == between.against)
      compare(one, other, a.is_turned_round == b.is_turned_round);
  }

  template <class Load>
  constexpr void compare(const Load& one, const Load& other, bool is_opposite) {
    if (one.value.is_zero() || other.value.is_zero()) return;
    vector difference = one.value;
    is_opposite ? difference.add(other.value) : difference.subtract(other.value);
    if (difference.is_zero())
      by_.fail({told(one, other).view()});
    else if (is_turned(one.value, other.value) &&
             hold_the_same(one.value, other.value, {kind::parameter, kind::input, kind::speed}))
      doubtful_.push({&one.value, &other.value, is_opposite, {}, {}, told(one, other)});
  }

  constexpr bool holds_input(const vector& v) const {
    for (const vector::part& p : v.parts)
      for (int i = 0; i < 3; ++i)
        if (held_.holds(p.value[i], kind::input)) return true;
    return false;
  }
  /// Whether one vector has a component along axes that the other lacks.
  static constexpr bool is_turned(const vector& a, const vector& b) {
    for (const vector::part& p : a.parts) {
      bool found = p.value.is_zero();
      for (const vector::part& other : b.parts) found = found || other.frame == p.frame;
      if (!found) return true;
    }
    return false;
  }
  constexpr void collect(expression e, kind k, sequence<int>& nodes) const { held_.collect(e, k, nodes); }
  constexpr void collect(const vector& v, kind k, sequence<int>& nodes) const {
    for (const vector::part& p : v.parts)
      for (int i = 0; i < 3; ++i) held_.collect(p.value[i], k, nodes);
  }
  template <class Value>
  constexpr bool hold_the_same(const Value& a, const Value& b, std::initializer_list<kind> kinds) const {
    for (kind k : kinds) {
      sequence<int> of_a, of_b;
      collect(a, k, of_a);
      collect(b, k, of_b);
      if (of_a.size() != of_b.size()) return false;
      for (int node : of_a)
        if (!of_b.contains(node)) return false;
    }
    return true;
  }

  constexpr void check_energies() {
    const sequence<given_potential_energy>& all = acting_.potential_energies;
    for (int i = 0; i < all.size(); ++i)
      for (int j = 0; j < i && !by_.mistake(); ++j) {
        const expression one = all[i].value, other = all[j].value;
        if (one.is_constant()) continue; // it has no effect, such as a spring without stiffness
        const sentence told({"potential energy ", counted(i + 1).view(), " repeats potential energy ",
                             counted(j + 1).view()});
        if (one == other)
          by_.fail({told.view()});
        else if (hold_the_same(one, other, {kind::coordinate, kind::parameter, kind::input}))
          doubtful_.push({nullptr, nullptr, false, one, other, told});
      }
  }

  constexpr void check_in_numbers() {
    if (doubtful_.empty() || by_.mistake()) return;
    sequence<expression> all;
    for (const doubt& d : doubtful_) {
      if (d.one == nullptr) all.push(d.energy), all.push(d.other_energy);
      for (const vector* v : {d.one, d.other})
        for (int i = 0; v != nullptr && i < 3; ++i)
          for (const vector::part& p : v->parts) all.push(p.value[i]);
    }
    generic_motion motion(m_, held_, all);
    for (int tries = 0; tries < 6; ++tries) {
      motion.draw();
      if (!motion.move(false) && !motion.move_freely()) continue;
      for (const doubt& d : doubtful_)
        if (is_same(d, motion)) return by_.fail({d.told.view()});
      return;
    }
  }
  /// Whether two energies are equal up to a constant.
  static constexpr bool is_same(const doubt& d, const generic_motion& motion) {
    const bool is_energy = d.one == nullptr;
    if (is_energy ? !motion.is_defined(d.energy) || !motion.is_defined(d.other_energy)
                  : !motion.is_defined(*d.one) || !motion.is_defined(*d.other))
      return false;
    const triple one = is_energy ? triple{motion[d.energy].rate, 0, 0} : motion.vector_of(*d.one);
    const triple other = is_energy ? triple{motion[d.other_energy].rate, 0, 0} : motion.vector_of(*d.other);
    return length(one) > 0 && length(d.is_opposite ? one + other : one - other) <= 1e-10 * length(one);
  }

  constexpr sentence name_of(const force& f) const {
    return f.against == none ? sentence({"the force at ", by_.point(f.point)})
                             : sentence({"the force between ", by_.both_points(f.point, f.against).view()});
  }
  constexpr sentence name_of(const torque& t) const {
    return t.against == none ? sentence({"the torque on ", by_.frame(t.frame)})
                             : sentence({"the torque between ", by_.both_frames(t.frame, t.against).view()});
  }
  template <class Load>
  constexpr sentence told(const Load& one, const Load& other) const {
    const bool has_one_name = (place(one) == place(other) && one.against == other.against) ||
                              (place(one) == other.against && one.against == place(other));
    if (has_one_name) return sentence({name_of(other).view(), " is listed twice"});
    return sentence({name_of(one).view(), " repeats ", name_of(other).view()});
  }

  static constexpr bool is_pair(int a, int b, int c, int d) {
    return (a == c && b == d) || (a == d && b == c);
  }

  constexpr void check_springs() {
    const sequence<spring_damper>& all = acting_.spring_dampers;
    for (int i = 0; i < all.size(); ++i)
      for (int j = 0; j < i; ++j) {
        const spring_damper &one = all[i], &other = all[j];
        if (!is_pair(one.point, one.other, other.point, other.other)) continue;
        const sentence names = by_.both_points(other.point, other.other);
        if (!one.stiffness.is_zero() && one.stiffness == other.stiffness && one.length == other.length)
          by_.fail({"the spring between ", names.view(), " is listed twice"});
        if (!one.damping.is_zero() && one.damping == other.damping)
          by_.fail({"the damper between ", names.view(), " is listed twice"});
      }
  }

  constexpr void check_torsional_dampers() {
    const sequence<torsional_damper>& all = acting_.torsional_dampers;
    for (int i = 0; i < all.size(); ++i)
      for (int j = 0; j < i; ++j)
        if (is_pair(all[i].frame, all[i].against, all[j].frame, all[j].against) &&
            all[i].damping == all[j].damping)
          by_.fail({"the torsional damper between ", by_.both_frames(all[j].frame, all[j].against).view(),
                    " is listed twice"});
  }

  const mechanism& m_;
  const loads& acting_;
  const contents& held_;
  load_check& by_;
  sequence<doubt> doubtful_{};
};

/// Defined after the templates it uses, which clang++ must have parsed already.
constexpr void checking_repeated_loads::run() {
  check_pairs(acting_.forces);
  check_pairs(acting_.torques);
  check_energies();
  check_in_numbers();
  check_springs();
  check_torsional_dampers();
}

} // namespace detail

constexpr void check_repeated_loads(const mechanism& m, const loads& acting, const contents& held,
                                    load_check& by) {
  detail::checking_repeated_loads(m, acting, held, by).run();
}

} // namespace kanexpr::mechanics
