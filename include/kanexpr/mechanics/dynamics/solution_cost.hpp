#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/inward_steps.hpp>
#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/elimination_cost.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

/// The choice between two solutions of the same equations by what their operations cost.
namespace kanexpr::mechanics {

using symbolic::operation_weights;

/// The cost of u̇ = M⁻¹ f by composite bodies and elimination of M, including M and f.
constexpr symbolic::cost cost_by_elimination(const symbolic::matrix& mass,
                                             const sequence<expression>& force) {
  sequence<expression> all = force;
  for (int i = 0; i < mass.rows; ++i)
    for (int j = 0; j <= i; ++j) all.push(mass(i, j));
  const symbolic::cost formed = symbolic::cost_of(all[0].owner(), symbolic::nodes_of(all));
  return added(formed, symbolic::elimination_cost(mass));
}

/// The cost of a solution, with the entries to which its pivots are compared.
constexpr symbolic::cost cost_of(const symbolic::symmetric_solution& solved) {
  sequence<expression> all = solved.x;
  for (const symbolic::pivot& p : solved.pivots) all.push(p.entry);
  return symbolic::cost_of(all[0].owner(), symbolic::nodes_of(all));
}

namespace detail {

/// Whether all frames that rotate share their axes, as in a planar mechanism.
constexpr bool is_planar(const skeleton& s) {
  int common = none;
  for (int f = 1; f < s.working_axes.size(); ++f) {
    if (s.rigid_with[f] == mechanism::inertial) continue;
    if (common == none) common = s.working_axes[f];
    if (s.working_axes[f] != common) return false;
  }
  return true;
}

struct threshold {
  int speeds, operations; ///< the operations are those for each speed
};

/// Most products of an elimination are fused with a sum.
constexpr long long weighted(const threshold& t, int speeds, const operation_weights& by) {
  return 1LL * by.fused * t.operations * speeds / 2;
}

} // namespace detail

/// Whether a solution by articulated bodies may cost less, judged by a lower bound for each speed. Forming a
/// solution that is not used costs compile time.
constexpr bool may_pay_by_articulated_bodies(const skeleton& s, const symbolic::matrix& mass,
                                             const sequence<expression>& force, const operation_weights& by) {
  constexpr detail::threshold in_plane{7, 50}, in_space{10, 150}; // measured on chains and trees
  const detail::threshold fewest = detail::is_planar(s) ? in_plane : in_space;
  if (mass.rows < fewest.speeds) return false;
  const symbolic::cost formed = symbolic::cost_of(*s.model->g, symbolic::nodes_of(force));
  return cost_by_elimination(mass, force).weighted(by) - formed.weighted(by) >
         detail::weighted(fewest, mass.rows, by);
}

/// Estimates the elimination of M from the tree of joints, before M is formed. Each speed is assumed to be
/// coupled to all speeds inward. As translations may be coupled to few of them, a quarter is assumed if there
/// are any. The estimate is zero if a speed enters at several joints.
class elimination_estimate {
public:
  constexpr explicit elimination_estimate(const skeleton& s)
      : s_(s), motions_(s.model->ways(), 0), of_frames_(s.model->frames.size(), none) {
    of_frames_[mechanism::inertial] = 0;
    for (int f = 1; f < of_frames_.size(); ++f)
      if (s_.rigid_with[f] == f) count(s_.partial_angular_velocities[f]);
    for (const sequence<partial_velocity>& partials : s_.partial_velocities) {
      count(partials);
      if (!partials.empty()) translates_ = true;
    }
    for (int n = 0; n < s_.stations.size(); ++n) {
      const int parent = s_.stations[n].parent;
      const int inward = parent == none || s_.stations[n].absolute ? 0 : of_stations_[parent];
      of_stations_.push(inward + s_.partial_velocities[n].size());
    }
    for (const inward_step& each : inward_steps(s_)) add(each);
  }

  constexpr long long weighted(const operation_weights& by) const {
    if (!enters_once_) return 0;
    return total_.weighted(by) / (translates_ ? 4 : 1);
  }

private:
  constexpr void count(const sequence<partial_velocity>& partials) {
    for (const partial_velocity& v : partials) enters_once_ = enters_once_ && motions_[v.speed]++ == 0;
  }

  /// The number of speeds that rotate a frame.
  constexpr int speeds_of(int frame) {
    int& known = of_frames_[frame];
    if (known == none) known = s_.partial_angular_velocities[frame].size() + speeds_of(s_.turns_in[frame]);
    return known;
  }

  constexpr void add(const inward_step& now) {
    const int n = now.station, own = now.is_rotation() ? s_.partial_angular_velocities[now.frame].size()
                                                       : s_.partial_velocities[n].size();
    if (own == 0) return;
    const int inward = speeds_of(now.below) + of_stations_[n] - (now.is_rotation() ? 0 : own);
    for (int i = 0; i < own; ++i) symbolic::count_elimination(total_, inward + i);
  }

  const skeleton& s_;
  sequence<int> motions_;   ///< by speed: the number of joints at which it enters
  sequence<int> of_frames_; ///< by frame: the number of speeds that rotate it
  sequence<int> of_stations_{};
  bool enters_once_ = true, translates_ = false;
  symbolic::cost total_{};
};

/// Whether a solution by articulated bodies is likely to cost less than the elimination of M alone.
constexpr bool is_too_long_for_elimination(const skeleton& s, const operation_weights& by) {
  constexpr detail::threshold in_plane{12, 80}, in_space{16, 290}; // measured on chains with symbols only
  const detail::threshold fewest = detail::is_planar(s) ? in_plane : in_space;
  const int speeds = s.model->speeds_of_motion();
  return speeds >= fewest.speeds &&
         elimination_estimate(s).weighted(by) > detail::weighted(fewest, speeds, by);
}

/// Whether a solution costs less than the elimination of M alone, with forces that both need.
constexpr bool costs_less_than_elimination(const skeleton& s, const symbolic::symmetric_solution& solved,
                                           const sequence<expression>& force, const operation_weights& by) {
  const long long own = cost_of(solved).weighted(by), estimate = elimination_estimate(s).weighted(by);
  if (own < estimate) return true; // whatever the forces cost
  return own < symbolic::cost_of(*s.model->g, symbolic::nodes_of(force)).weighted(by) + estimate;
}

} // namespace kanexpr::mechanics
