#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/axes.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/time_derivative.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// A result that is formed once.
template <class Value>
struct remembered {
  bool known = false;
  Value value{};
  constexpr const Value& keep(const Value& formed) {
    known = true;
    return value = formed;
  }
};

/// U = [α]× + [ω]×[ω]×: the acceleration of a point at r in a frame is a + U r.
constexpr matrix3 acceleration_matrix(const components& w, const components& alpha) {
  const expression xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z;
  const expression xy = w.x * w.y, yz = w.y * w.z, zx = w.z * w.x;
  matrix3 u;
  u.row[0] = {-(yy + zz), xy - alpha.z, zx + alpha.y};
  u.row[1] = {xy + alpha.z, -(zz + xx), yz - alpha.x};
  u.row[2] = {zx - alpha.y, yz + alpha.x, -(xx + yy)};
  return u;
}

/// Angular velocities and accelerations of frames, and velocities and accelerations of the skeleton's
/// stations, all in the inertial frame and each in its own working axes. Each is formed once, outward from
/// the ground, and stored.
class motion {
public:
  constexpr motion() = default;
  motion(const motion&) = delete;
  motion(motion&&) = default;
  motion& operator=(const motion&) = delete;
  motion& operator=(motion&&) = default;
  /// `udot` are the rates of the speeds; without them, all accelerations are evaluated at u̇ = 0, which gives
  /// the bias of Kane's equations.
  constexpr explicit motion(const skeleton& s, const sequence<expression>& udot = {})
      : s_(&s), m_(s.model), along_time_(time_derivative(*s.model, s.coordinate_rates, udot)),
        omega_(s.model->frames.size()), alpha_(s.model->frames.size()), carry_(s.model->frames.size()),
        velocity_(s.stations.size()), acceleration_(s.stations.size()) {}

  constexpr const skeleton& skeleton_used() const { return *s_; }

  /// Updates the address of the skeleton after the skeleton has been moved.
  constexpr void follow(const skeleton& s) { s_ = &s; }

  /// The time derivative of a scalar.
  constexpr expression rate(expression e) { return along_time_.of(e); }

  /// Substitutes the coordinate rates from the kinematic equations into a scalar.
  constexpr expression known(expression e) const { return known_rates(*m_, s_->coordinate_rates).in(e); }

  /// Gives the ground a uniform acceleration; an acceleration of −g replaces gravity on every body.
  constexpr void accelerate_ground(const vector& acceleration) {
    ground_ = known_rates(*m_, s_->coordinate_rates).in(acceleration);
  }

  constexpr const vector& ground_acceleration() const { return ground_; }

  /// The angular velocity of frame `f`, in its working axes.
  constexpr components angular_velocity(int f) {
    f = s_->rigid_with[f];
    if (omega_[f].known) return omega_[f].value;
    components w(*m_->g);
    if (f != mechanism::inertial) {
      const int p = s_->turns_in[f];
      w = turn(angular_velocity(p), p, f);
      w += express(*m_, s_->relative_angular_velocity[f], s_->working_axes[f]);
    }
    return omega_[f].keep(w);
  }

  /// The angular acceleration of frame `f`, in its working axes.
  constexpr components angular_acceleration(int f) {
    f = s_->rigid_with[f];
    if (alpha_[f].known) return alpha_[f].value;
    components a(*m_->g);
    if (f != mechanism::inertial) {
      const int p = s_->turns_in[f];
      a = turn(angular_acceleration(p), p, f);
      a += rate(s_->relative_angular_velocity[f], f);
    }
    return alpha_[f].keep(a);
  }

  constexpr const matrix3& acceleration_matrix(int f) {
    f = s_->rigid_with[f];
    if (carry_[f].known) return carry_[f].value;
    const components w = angular_velocity(f), a = angular_acceleration(f);
    return carry_[f].keep(mechanics::acceleration_matrix(w, a));
  }

  /// The velocity of a station, in its working axes.
  constexpr components velocity(int n) {
    if (velocity_[n].known) return velocity_[n].value;
    const station& at = s_->stations[n];
    components v(*m_->g);
    if (!at.absolute) {
      v = velocity(at.parent, at.axes);
      const components w = angular_velocity(at.frame), r = s_->offset_in_working_axes(n);
      v += cross(w, r);
    }
    v += express(*m_, at.relative_velocity, s_->working_axes[at.axes]);
    return velocity_[n].keep(v);
  }

  /// The acceleration of a station, in its working axes.
  constexpr components acceleration(int n) {
    if (acceleration_[n].known) return acceleration_[n].value;
    const station& at = s_->stations[n];
    components a(*m_->g);
    if (at.absolute) {
      a = express(*m_, ground_, s_->working_axes[at.axes]);
    } else {
      a = acceleration(at.parent, at.axes);
      const components r = s_->offset_in_working_axes(n);
      if (at.carried) {
        a += acceleration_matrix(at.frame) * r;
      } else {
        components of_offset = cross(angular_acceleration(at.frame), r);
        const components w = angular_velocity(at.frame), change = rate(at.offset(), at.frame);
        of_offset += cross(w, change);
        a += of_offset;
      }
      if (at.carried && !at.relative_velocity.parts.empty()) {
        const components w = angular_velocity(at.frame);
        a += cross(w, express(*m_, at.relative_velocity, s_->working_axes[at.frame]));
      }
    }
    if (!at.relative_velocity.parts.empty()) a += rate(at.relative_velocity, at.axes);
    return acceleration_[n].keep(a);
  }

  /// The station with velocity `v`, given in the axes of frame `axes`; or none.
  constexpr int station_with_velocity(const components& v, int axes) {
    for (int n = 0; n < velocity_.size(); ++n)
      if (s_->working_axes[s_->stations[n].axes] == axes && velocity(n) == v) return n;
    return none;
  }

  constexpr components velocity(int n, int frame) { return turn(velocity(n), s_->stations[n].axes, frame); }
  constexpr components acceleration(int n, int frame) {
    return turn(acceleration(n), s_->stations[n].axes, frame);
  }

  /// Transforms components from the working axes of one frame to those of another.
  constexpr components turn(const components& v, int from, int to) const {
    return express(*m_, v, s_->working_axes[from], s_->working_axes[to]);
  }

  /// The inertial time derivative of a vector, in the working axes of `f`.
  constexpr components rate(const vector& v, int f) {
    components total(*m_->g);
    for (const vector::part& p : v.parts) {
      const components own{rate(p.value.x), rate(p.value.y), rate(p.value.z)};
      const components here = express(*m_, p.value, p.frame, s_->working_axes[f]);
      components of_part = express(*m_, own, p.frame, s_->working_axes[f]);
      of_part += cross(turn(angular_velocity(p.frame), s_->rigid_with[p.frame], f), here);
      total += of_part;
    }
    return total;
  }

private:
  const skeleton* s_ = nullptr;
  const mechanism* m_ = nullptr;
  symbolic::differentiation along_time_{};
  vector ground_{};
  sequence<remembered<components>> omega_{}, alpha_{};
  sequence<remembered<matrix3>> carry_{};
  sequence<remembered<components>> velocity_{}, acceleration_{};
};

} // namespace kanexpr::mechanics
