#pragma once

#include <kanexpr/mechanics/known_rates.hpp>
#include <kanexpr/mechanics/motion.hpp>

namespace kanexpr::mechanics {

/// Generalized forces Σ v_r·R + ω_r·T by reverse accumulation through the velocity map: forces run down the
/// tree of points, moments down the tree of frames, and each speed picks up its share where it enters. Kane &
/// Levinson (1985), section 4.4, in time proportional to the number of links.
class generalized_forces {
public:
  constexpr explicit generalized_forces(const skeleton& s)
      : s_(s), m_(*s.model), known_(m_, s.coordinate_rates), force_(s.nodes.size(), components(*m_.g)),
        moment_(m_.frames.size(), components(*m_.g)),
        share_(m_.speeds.size(), expression{*m_.g, graph::zero}) {}

  /// Forces and torques of the model; gravity on every body only if it is not taken as an acceleration.
  constexpr void add_loads(bool gravity) {
    for (const torque& t : m_.torques) add_moment(s_.rigid_with[t.frame], known_.in(t.value));
    for (const force& f : m_.forces) add_force(s_.node_of_point[f.point], known_.in(f.value));
    if (!gravity || !m_.has_gravity) return;
    for (const body& b : m_.bodies) add_force(s_.node_of_point[b.center], b.mass * known_.in(m_.gravity));
  }

  /// What inertia asks for at u̇ = 0, with the minus sign of a generalized inertia force.
  constexpr void add_inertia_bias(motion& k) {
    for (const link& l : s_.base_links) {
      const int f = l.frame;
      const path to_working(m_, s_.body_axes[f], s_.working_axes[f]);
      const components h = to_working.turn(l.mass.first_moment);
      const symmetric inertia = to_working.turn(l.mass.inertia);
      const components a = k.acceleration(l.node, f);
      const components demand = l.mass.mass * a + (h.is_zero() ? h : k.carry(f) * h);
      force_[l.node] -= k.turn(demand, f, s_.nodes[l.node].axes);
      moment_[f] -= cross(h, a) + inertia_demand(k, inertia, f);
    }
  }

  /// The generalized force of each speed.
  constexpr const sequence<expression>& run() {
    for (int n = s_.nodes.size() - 1; n >= 0; --n) {
      const node& at = s_.nodes[n];
      if (force_[n].is_zero()) continue;
      for (const direction& v : s_.partial_slide[n]) share_[v.speed] += dot(v.value, force_[n]);
      if (at.absolute || at.parent == none) continue;
      moment_[at.frame] += cross(s_.offset_in_working_axes(n), force_[n]);
      const int parent_axes = s_.nodes[at.parent].axes;
      force_[at.parent] += turn(force_[n], at.axes, parent_axes);
    }
    for (int f : tips_first()) {
      if (moment_[f].is_zero()) continue;
      for (const direction& w : s_.partial_turning[f]) share_[w.speed] += dot(w.value, moment_[f]);
      const int below = s_.turns_in[f];
      if (below != mechanism::inertial) moment_[below] += turn(moment_[f], f, below);
    }
    return share_;
  }

private:
  constexpr components turn(const components& v, int from, int to) const {
    return express(m_, v, s_.working_axes[from], s_.working_axes[to]);
  }

  constexpr void add_force(int n, const vector& value) {
    force_[n] += express(m_, value, s_.working_axes[s_.nodes[n].axes]);
  }
  constexpr void add_moment(int f, const vector& value) {
    if (f != mechanism::inertial) moment_[f] += express(m_, value, s_.working_axes[f]);
  }

  /// I·α + ω×(I·ω) about the link's node, from the matrix U that its forces use as well: with the products of
  /// inertia as weights of U's entries it takes half the products of the two-step form.
  constexpr components inertia_demand(motion& k, const symmetric& i, int f) {
    components moment(*m_.g);
    if (i.is_zero()) return moment;
    const components w = k.angular_velocity(f), alpha = k.angular_acceleration(f);
    for (int x = 0; x < 3; ++x) {
      const int y = (x + 1) % 3, z = (x + 2) % 3;
      const matrix3& u = k.carry(f);
      moment[x] = i(x, x) * alpha[x] + (i(z, z) - i(y, y)) * (w[y] * w[z]) +
                  i(y, z) * (w[y] * w[y] - w[z] * w[z]) + i(z, x) * u(y, x) - i(x, y) * u(z, x);
    }
    return moment;
  }

  /// Frames that turn, those farther from the ground before those that they turn in.
  constexpr sequence<int> tips_first() const {
    sequence<int> order;
    sequence<int> waiting(m_.frames.size(), 0); // how many frames turn in this one and are not listed yet
    for (int f = 1; f < m_.frames.size(); ++f)
      if (s_.rigid_with[f] == f) ++waiting[s_.turns_in[f]];
    for (int f = 1; f < m_.frames.size(); ++f)
      if (s_.rigid_with[f] == f && waiting[f] == 0) order.push(f);
    for (int i = 0; i < order.size(); ++i) {
      const int below = s_.turns_in[order[i]];
      if (--waiting[below] == 0 && below != mechanism::inertial) order.push(below);
    }
    return order;
  }

  const skeleton& s_;
  const mechanism& m_;
  known_rates known_;
  sequence<components> force_;
  sequence<components> moment_;
  sequence<expression> share_;
};

} // namespace kanexpr::mechanics
