#pragma once

#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>

/// Mistakes in what acts on a system.
namespace kanexpr::mechanics {

/// Speeds or rates in what must be a function of coordinates, parameters, inputs and time.
constexpr sentence check_stillness(const mechanism& m, const contents& held, expression e,
                                   std::string_view of, std::string_view whose) {
  using kind = symbolic::symbol_kind;
  if (held.holds(e, kind::speed))
    return sentence({of, whose, " holds the ", speed_called(m, held.name_of(e, kind::speed)).view(),
                     "; it may hold coordinates only"});
  if (held.holds(e, kind::auxiliary_speed))
    return sentence({of, whose, " holds the auxiliary speed ", held.name_of(e, kind::auxiliary_speed),
                     "; it may hold coordinates only"});
  if (held.holds(e, kind::coordinate_rate))
    return sentence({of, whose, " holds the rate of coordinate ", held.name_of(e, kind::coordinate_rate)});
  if (held.holds(e, kind::speed_rate))
    return sentence(
        {of, whose, " holds the ", speed_rate_called(m, held.name_of(e, kind::speed_rate)).view()});
  return {};
}

namespace detail {

class checking_loads {
public:
  constexpr checking_loads(const mechanism& m, const contents& held) : m_(m), held_(held) {}

  constexpr sentence run() {
    for (const force& f : m_.forces) look_at(f);
    for (const torque& t : m_.torques) look_at(t);
    check_gravity();
    for (int i = 0; i < m_.potential_energies.size() && !found_; ++i)
      found_ =
          check_stillness(m_, held_, m_.potential_energies[i], "potential energy ", counted(i + 1).view());
    for (const spring_damper& e : m_.spring_dampers) look_at(e);
    for (const torsional_damper& e : m_.torsional_dampers) look_at(e);
    return found_;
  }

private:
  using kind = symbolic::symbol_kind;

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!found_) found_ = sentence(pieces);
  }
  constexpr void fail_for_rate(std::string_view of, std::string_view whose, std::string_view speed) {
    fail({of, whose, " holds the ", speed_rate_called(m_, speed).view()});
  }

  /// The speed whose rate an expression holds.
  constexpr std::string_view rate_in(expression e) const {
    if (!held_.holds(e, kind::speed_rate)) return {};
    return held_.name_of(e, kind::speed_rate);
  }
  constexpr std::string_view rate_in(const vector& v) const {
    for (const vector::part& part : v.parts)
      for (int i = 0; i < 3; ++i)
        if (const std::string_view u = rate_in(part.value[i]); !u.empty()) return u;
    return {};
  }

  constexpr std::string_view frame(int f) const { return m_.frames[f].called.view(); }
  constexpr std::string_view point(int p) const { return m_.points[p].called.view(); }
  constexpr sentence both_frames(int f, int other) const {
    return sentence({frame(f), " and ", frame(other)});
  }
  constexpr sentence both_points(int p, int other) const {
    return sentence({point(p), " and ", point(other)});
  }

  constexpr void look_at(const force& f) {
    if (f.against == f.point) fail({"a force acts between point ", point(f.point), " and itself"});
    const std::string_view u = rate_in(f.value);
    if (u.empty()) return;
    if (f.against == none) return fail_for_rate("the force at ", point(f.point), u);
    fail_for_rate("the force between ", both_points(f.point, f.against).view(), u);
  }

  constexpr void look_at(const torque& t) {
    if (t.against == t.frame) fail({"a torque acts between frame ", frame(t.frame), " and itself"});
    const std::string_view u = rate_in(t.value);
    if (u.empty()) return;
    if (t.against == none) return fail_for_rate("the torque on ", frame(t.frame), u);
    fail_for_rate("the torque between ", both_frames(t.frame, t.against).view(), u);
  }

  constexpr void look_at(const torsional_damper& e) {
    if (e.frame == e.against) fail({"a torsional damper lies between frame ", frame(e.frame), " and itself"});
    if (const std::string_view u = rate_in(e.damping); !u.empty())
      fail_for_rate("the torsional damping between ", both_frames(e.frame, e.against).view(), u);
  }

  constexpr void look_at(const spring_damper& e) {
    const std::string_view what = e.stiffness.is_zero() ? "damper" : "spring";
    if (e.point == e.other) return fail({"a ", what, " lies between point ", point(e.point), " and itself"});
    const sentence names = both_points(e.point, e.other);
    const int origin = origin_of(e.point), other_origin = origin_of(e.other);
    if (origin != other_origin)
      return fail({"the ", what, " between ", names.view(), " hangs on two origins, ",
                   both_points(origin, other_origin).view(), ", whose distance is not known"});
    if ((position_from_origin(m_, e.point) - position_from_origin(m_, e.other)).is_zero())
      return fail({"the ", what, " between ", names.view(), " has no length in any configuration"});
    constant_in_motion(e.stiffness, "the stiffness of the spring between ", names.view());
    constant_in_motion(e.length, "the natural length of the spring between ", names.view());
    if (const std::string_view u = rate_in(e.damping); !u.empty())
      fail_for_rate("the damping between ", names.view(), u);
  }

  /// Its potential energy is −m g·r, and its force m g: the derivative of the energy only where g has none.
  constexpr void check_gravity() {
    std::string_view coordinate, turns; // that it holds, and the frame that turns with it
    for (const vector::part& part : m_.gravity.parts) {
      for (int i = 0; i < 3; ++i) {
        free_of_rates(part.value[i], "gravity", {});
        if (held_.holds(part.value[i], kind::coordinate))
          coordinate = held_.name_of(part.value[i], kind::coordinate);
      }
      for (int f = part.frame; f != mechanism::inertial && !part.value.is_zero(); f = m_.frames[f].parent)
        if (const std::string_view q = coordinate_of(m_.frames[f]); !q.empty() && coordinate.empty())
          coordinate = q, turns = frame(part.frame);
    }
    if (found_ || coordinate.empty() || !gravity_changes()) return;
    if (turns.empty()) return varies("gravity", {}, sentence({"coordinate ", coordinate}));
    fail({"gravity is given along axes of ", turns, ", which turn with coordinate ", coordinate,
          "; it may hold parameters, inputs and time only"});
  }
  /// A coordinate that a frame turns with in its parent.
  constexpr std::string_view coordinate_of(const mechanics::frame& f) const {
    if (f.kind != orientation::matrix)
      return held_.holds(f.angle, kind::coordinate) ? held_.name_of(f.angle, kind::coordinate) : "";
    for (int i = 0; i < 9; ++i)
      if (const expression e = f.to_parent(i / 3, i % 3); held_.holds(e, kind::coordinate))
        return held_.name_of(e, kind::coordinate);
    return {};
  }
  /// Whether it depends on coordinates in the end: given along several axes it may be one vector all the
  /// time.
  constexpr bool gravity_changes() const {
    const components g = express(m_, m_.gravity, mechanism::inertial);
    symbolic::matrix all(*m_.g, 1 + m_.coordinates.size(), 3); // g, then its derivatives
    for (int i = 0; i < 3; ++i) {
      all(0, i) = g[i];
      for (int j = 1; j < all.rows; ++j) all(j, i) = symbolic::differentiate(g[i], m_.coordinates[j - 1]);
    }
    for (const numbers& state : at_generic_states(all)) {
      double whole = 0, most = 0;
      for (int i = 0; i < state.entries.size(); ++i) {
        const double size = elementary::abs(state.entries[i]);
        if (i < 3) whole += size;
        if (i >= 3 && size > most) most = size;
      }
      if (most > 1e-9 * whole) return true;
    }
    return false;
  }

  /// What would be a force of its own if it changed with coordinates.
  constexpr void constant_in_motion(expression e, std::string_view of, std::string_view whose) {
    if (held_.holds(e, kind::coordinate))
      varies(of, whose, sentence({"coordinate ", held_.name_of(e, kind::coordinate)}));
    free_of_rates(e, of, whose);
  }
  constexpr void free_of_rates(expression e, std::string_view of, std::string_view whose) {
    struct named_kind {
      kind what;
      std::string_view called;
    };
    for (const named_kind& w : {named_kind{kind::auxiliary_speed, "auxiliary speed "},
                                named_kind{kind::coordinate_rate, "rate of coordinate "}})
      if (held_.holds(e, w.what)) varies(of, whose, sentence({w.called, held_.name_of(e, w.what)}));
    if (held_.holds(e, kind::speed)) varies(of, whose, speed_called(m_, held_.name_of(e, kind::speed)));
    if (held_.holds(e, kind::speed_rate))
      varies(of, whose, speed_rate_called(m_, held_.name_of(e, kind::speed_rate)));
  }
  constexpr void varies(std::string_view of, std::string_view whose, const sentence& with) {
    fail({of, whose, " holds the ", with.view(), "; it may hold parameters, inputs and time only"});
  }

  constexpr int origin_of(int p) const {
    while (m_.points[p].parent != none) p = m_.points[p].parent;
    return p;
  }

  const mechanism& m_;
  const contents& held_;
  sentence found_{};
};

} // namespace detail

/// Of loads alone: the first mistake, or nothing.
constexpr sentence check_loads(const mechanism& m) { return detail::checking_loads(m, contents(*m.g)).run(); }

} // namespace kanexpr::mechanics
