#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_constraints.hpp>
#include <kanexpr/mechanics/dynamics/lagrange.hpp>
#include <kanexpr/mechanics/model/check_contents.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/time_derivative.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Checks that apply only to Lagrange's method.
namespace kanexpr::mechanics {

namespace detail {

/// Whether expressions vanish in every configuration, up to rounding.
constexpr bool vanish(const mechanism& m, const sequence<expression>& all) {
  symbolic::matrix a(*m.g, all.size(), 1);
  a.entries = all;
  for (const numbers& state : at_generic_states(a, &m))
    for (double e : state.entries)
      if (!base::equal(e, 0.0)) return false;
  return true;
}

/// The endings of the error messages.
struct wording_of_rates {
  std::string_view of_velocity, of_mass;
};
inline constexpr wording_of_rates by_lagrange{", as Lagrange's method requires",
                                              "; with Lagrange's method it may depend only on time"};

/// Checks a mechanism for Lagrange's method. Kane's method uses velocities as declared; here they must be the
/// rates of positions and orientations, with respect to which the kinetic energy is differentiated.
class lagrange_checker {
public:
  constexpr lagrange_checker(motion& k, const loads& acting, const wording_of_rates& wording)
      : k_(k), s_(k.skeleton_used()), m_(*s_.model), loads_(acting), wording_(wording), held_(*m_.g) {}

  constexpr sentence run() {
    if (loads_.has_lagrangian) check_lagrangian();
    for (int f = 0; f < m_.frames.size() && !found_; ++f) check_angular_velocity(f);
    for (const body& b : m_.bodies) {
      if (found_) break;
      check_velocity(b.called, b.center);
      check_mass(b);
    }
    for (const flexible_body& b : m_.flexible_bodies)
      if (!found_) check_velocity(b.called, b.reference);
    for (int p = 0; p < m_.points.size() && !found_; ++p)
      if (m_.points[p].has_declared_velocity() && !m_.points[p].moves_apart &&
          !m_.points[p].offset.is_zero() && !follows_position(p))
        fail({"the velocity of point ", m_.points[p].called.view(),
              " is not the rate of its position; if this is intended, write velocity_apart_from_position"});
    return found_;
  }

private:
  using kind = symbolic::symbol_kind;

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!found_) found_ = sentence(pieces);
  }

  constexpr void check_lagrangian() {
    const expression l = loads_.lagrangian;
    if (const sentence rate = symbol_in(m_, held_, l, {kind::speed_rate}))
      return fail({"the Lagrangian contains the ", rate.view()});
    if (found_ = check_no_state_variable(m_, held_, l, "the Lagrangian"); found_) return;
    if (loads_.has_gravity)
      return fail({"gravity acts on bodies, but a system given by a Lagrangian has none; add the potential "
                   "energy of gravity to the Lagrangian"});
    for (const expression& p : gradient_of(m_, l).momenta)
      if (!found_)
        found_ = check_prescribed(m_, contents(*m_.g), p, 1,
                                  "a derivative of the Lagrangian with respect to a rate");
  }

  /// Compares a declared angular velocity with the one that follows from the orientation.
  constexpr void check_angular_velocity(int place) {
    if (!m_.frames[place].has_declared_angular_velocity()) return;
    symbolic::differentiation along_time = time_derivative(m_, s_.coordinate_rates);
    symbolic::substitution at_norm_one(*m_.g);
    components w =
        express(m_, k_.angular_velocity(place), s_.working_axes[s_.rigid_with[place]], mechanism::inertial);
    for (int f = place; f != mechanism::inertial; f = m_.frames[f].parent) {
      w -= express(m_, relative_angular_velocity(m_, f, along_time), mechanism::inertial);
      normalize(m_.frames[f].quaternion, at_norm_one, along_time);
    }
    if (!vanish(m_, {at_norm_one.in(w.x), at_norm_one.in(w.y), at_norm_one.in(w.z)}))
      fail({"the declared angular velocity of frame ", m_.frames[place].called.view(),
            " does not match its orientation", wording_.of_velocity});
  }

  /// Replaces a quaternion e by e/|e|, and its rate accordingly, because it describes a rotation only if its
  /// norm is 1.
  constexpr void normalize(const sequence<expression>& quaternion, symbolic::substitution& at_norm_one,
                           symbolic::differentiation& along_time) const {
    expression squares = m_.zero();
    for (const expression& e : quaternion) squares += e * e;
    for (const expression& e : quaternion) {
      const int i = m_.coordinates.find(e);
      if (i < 0) continue;
      const expression of_norm_one = e / sqrt(squares);
      at_norm_one.replace(e, of_norm_one);
      if (m_.speeds.contains(s_.coordinate_rates[i]))
        at_norm_one.replace(s_.coordinate_rates[i], along_time.of(of_norm_one));
    }
  }

  constexpr void check_velocity(const name& body, int point) {
    bool declared = false;
    for (int p = point; p != none; p = m_.points[p].parent)
      declared = declared || m_.points[p].has_declared_velocity() || m_.points[p].fixed_in != none;
    if (declared && !follows_position(point))
      fail({"the velocity of ", body.view(), " is not the rate of its position", wording_.of_velocity});
  }

  constexpr bool follows_position(int point) {
    const int at = s_.station_of_point[point], ground = mechanism::inertial;
    components v = express(m_, k_.velocity(at), s_.working_axes[s_.stations[at].axes], ground);
    v -= express(m_, k_.rate(position_from_origin(m_, point), ground), s_.working_axes[ground], ground);
    return vanish(m_, {v.x, v.y, v.z});
  }

  /// Rejects a mass that depends on coordinates, which would add spurious terms to the derivatives of T. If a
  /// mass varies with time, force is the rate of change of momentum.
  constexpr void check_mass(const body& b) {
    if (held_.holds(b.mass, kind::coordinate))
      return fail({"the mass of ", b.called.view(), " depends on coordinate ",
                   held_.name_of(b.mass, kind::coordinate), wording_.of_mass});
    if (b.frame == none || has_plain_inertia(b)) return;
    const symmetric inertia = central_inertia(m_, b, b.frame);
    for (const expression& q : m_.coordinates) {
      sequence<expression> changes;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) changes.push(symbolic::differentiate(inertia(i, j), q));
      if (!vanish(m_, changes))
        return fail(
            {"the inertia of ", b.called.view(), " depends on coordinate ", called(m_, q), wording_.of_mass});
    }
  }

  /// Whether the inertia is given in the body's own axes, about its mass center, and without coordinates.
  constexpr bool has_plain_inertia(const body& b) const {
    bool is_plain = s_.has_own_axes(b);
    b.inertia.each_entry([&](expression e) { is_plain = is_plain && !held_.holds(e, kind::coordinate); });
    return is_plain;
  }

  motion& k_;
  const skeleton& s_;
  const mechanism& m_;
  const loads& loads_;
  const wording_of_rates& wording_;
  contents held_;
  sentence found_{};
};

} // namespace detail

/// Returns a message that describes the first mistake that matters only for Lagrange's method; empty if
/// there is none.
constexpr sentence check_lagrange(motion& k, const loads& acting) {
  return detail::lagrange_checker(k, acting, detail::by_lagrange).run();
}

} // namespace kanexpr::mechanics
