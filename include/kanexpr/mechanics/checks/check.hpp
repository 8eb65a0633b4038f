#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_angular_velocity.hpp>
#include <kanexpr/mechanics/checks/check_direction_cosines.hpp>
#include <kanexpr/mechanics/checks/check_flexible_body.hpp>
#include <kanexpr/mechanics/checks/check_inertia.hpp>
#include <kanexpr/mechanics/checks/check_inertia_at_states.hpp>
#include <kanexpr/mechanics/checks/check_kinematics.hpp>
#include <kanexpr/mechanics/checks/check_loads.hpp>
#include <kanexpr/mechanics/checks/check_omitted_angles.hpp>
#include <kanexpr/mechanics/checks/check_velocity.hpp>
#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/mechanics/model/check_contents.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Checks a system before its equations of motion are derived.
namespace kanexpr::mechanics {

namespace detail {

/// Runs the checks of a system; the mistake that the user should fix first is reported first.
class system_checker {
public:
  constexpr explicit system_checker(const multibody_system& of) : of_(of), m_(of.mechanism), held_(*m_.g) {}

  constexpr sentence run() {
    if (m_.speeds_of_motion() == 0)
      return sentence(
          {"the system has no ", m_.derived_by == method::kane ? "generalized speeds" : "coordinates"});
    if (m_.bodies.empty() && m_.flexible_bodies.empty() && !of_.loads.has_lagrangian)
      return sentence({"the system has no particles or rigid bodies"});
    found_ = kinematics_checker(m_, held_).run();
    for (int f = 0; f < m_.frames.size() && !found_; ++f) check_frame(f);
    for (const point& p : m_.points) check_point(p);
    for (const body& b : m_.bodies) check_body(b);
    for (int i = 0; i < m_.flexible_bodies.size() && !found_; ++i) found_ = check_flexible_body(m_, i, held_);
    if (!found_) found_ = check_loads(m_, of_.loads, held_);
    if (!found_) found_ = dyadics_checker(m_, held_).run();
    if (!found_ && m_.derived_by == method::kane) check_declarations(); // `check_lagrange` requires more
    return found_;
  }

  /// Checks the frames and points added after the first `frames` and `points`.
  constexpr sentence run_on_added(int frames, int points) {
    bool is_any_declared = false;
    for (int f = frames; f < m_.frames.size() && !found_; ++f) {
      check_frame(f);
      is_any_declared = is_any_declared || m_.frames[f].has_declared_angular_velocity();
    }
    for (int p = points; p < m_.points.size(); ++p) check_point(m_.points[p]);
    if (!found_ && is_any_declared && m_.derived_by == method::kane)
      found_ = angular_velocity_checker(m_, held_).run();
    if (!found_ && m_.derived_by == method::kane && velocity_checker::is_any_declared(m_, points))
      found_ = velocity_checker(m_, held_).run();
    return found_;
  }

private:
  using kind = symbolic::symbol_kind;

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!found_) found_ = sentence(pieces);
  }

  /// Checks a geometric quantity: it may contain coordinates, parameters and time, but no quantity whose rate
  /// is unknown.
  constexpr void check_geometry(expression e, std::string_view of, const name& whose) {
    if (e.is_constant()) return; // most components are zero
    if (!found_) found_ = check_no_rates(m_, held_, e, of, whose.view());
    if (!found_) found_ = check_prescribed(m_, held_, e, 2, of, whose.view());
  }

  /// Checks declared velocities and inertias at generic states.
  constexpr void check_declarations() {
    bool declared = false, apart = false;
    sequence<omitted_angle> angles;
    for (const frame& f : m_.frames) declared = declared || f.has_declared_angular_velocity();
    if (declared) {
      angular_velocity_checker checked(m_, held_);
      found_ = checked.run();
      apart = checked.is_any_apart();
      angles = checked.omitted_angles();
    }
    if (!found_ && (velocity_checker::is_any_declared(m_, 0) || velocity_checker::may_any_deviate(m_, held_)))
      found_ = velocity_checker(m_, held_).run();
    if (!found_) found_ = changing_inertia_checker(m_, held_, apart).run();
    if (!found_) found_ = omitted_angles_checker(of_, held_, angles).run();
  }

  constexpr void check_frame(int place) {
    const frame& f = m_.frames[place];
    if (f.is_by_angle()) check_geometry(f.angle, "the angle of frame ", f.called);
    if (f.kind == orientation::matrix)
      for (int i = 0; i < 9; ++i)
        check_geometry(f.to_parent(i / 3, i % 3), "the orientation of frame ", f.called);
    if (!found_) found_ = check_direction_cosines(m_, f);
    if (!f.has_declared_angular_velocity()) return;
    check_velocity_of(f.angular_velocity, "the angular velocity of frame ", f.called);
    // follows the chain of reference frames
    int steps =
        m_.frames
            .size(); // the bound ends loops that do not contain f; these are reported for a different frame
    for (int on = f.reference; on != none && steps > 0; --steps) {
      const frame& above = m_.frames[on];
      if (on == place)
        return fail({"the angular velocity of frame ", f.called.view(), " is given relative to ",
                     m_.frames[f.reference].called.view(), ", which turns with ", f.called.view()});
      on = above.has_declared_angular_velocity() ? above.reference : above.parent;
    }
  }

  constexpr void check_point(const point& p) {
    p.offset.each_entry([&](expression e) { check_geometry(e, "the offset of point ", p.called); });
    if (p.has_declared_velocity()) check_velocity_of(p.velocity, "the velocity of point ", p.called);
  }

  constexpr void check_velocity_of(const vector& v, std::string_view of, const name& whose) {
    v.each_entry([&](expression e) {
      if (!found_) found_ = check_no_state_variable(m_, held_, e, of, whose.view());
      if (!found_) found_ = check_prescribed(m_, held_, e, 1, of, whose.view());
      if (const sentence rate = symbol_in(m_, held_, e, {kind::speed_rate}))
        fail({of, whose.view(), " contains the ", rate.view()});
      if (!found_) found_ = check_linear(m_, held_, e, of, whose.view());
    });
  }

  constexpr void check_body(const body& b) {
    const std::string_view called = b.called.view();
    if (b.mass.is_zero() && !has_inertia(b)) fail({"body ", called, " has no mass"});
    if (is_negative(b.mass)) fail({"the mass of ", called, " is negative"});
    check_mass_of(b.mass, "the mass of ", called);
    b.inertia.each_entry([&](expression e) { check_mass_of(e, "the inertia of ", called); });
    if (!found_) found_ = check_inertia(m_, b);
  }

  /// Checks a mass or an inertia, which may depend on time, coordinates and prescribed quantities.
  constexpr void check_mass_of(expression e, std::string_view of, std::string_view whose) {
    if (e.is_constant()) return;
    if (const sentence with = symbol_in(
            m_, held_, e, {kind::speed, kind::auxiliary_speed, kind::speed_rate, kind::coordinate_rate}))
      return fail({of, whose, " depends on the ", with.view()});
    if (!found_) found_ = check_prescribed(m_, held_, e, 1, of, whose);
  }

  const multibody_system& of_;
  const mechanism& m_;
  contents held_;
  sentence found_{};
};

} // namespace detail

/// Returns a message that describes the first mistake in a system; empty if there is none. Constraints are
/// checked later, once the velocities have been derived.
constexpr sentence check_system(const multibody_system& of) { return detail::system_checker(of).run(); }

/// Checks frames and points that were added to a system after it had been derived.
constexpr sentence check_added_entities(const multibody_system& of, int frames, int points) {
  return detail::system_checker(of).run_on_added(frames, points);
}

/// Reports a zero on the diagonal of the mass matrix of the independent speeds.
constexpr sentence check_mass_matrix(const mechanism& m, const partition& speeds,
                                     const sequence<expression>& diagonal) {
  for (int i = 0; i < diagonal.size(); ++i)
    if (diagonal[i].is_zero()) {
      const int place = speeds.independent[i];
      return m.derived_by == method::kane
                 ? sentence({"speed ", called(m, m.speeds[place]), " moves no mass"})
                 : sentence({"coordinate ", called(m, m.coordinates[place]), " moves no mass"});
    }
  return {};
}

} // namespace kanexpr::mechanics
