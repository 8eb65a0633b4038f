#pragma once

#include <kanexpr/compiled/equations_of_motion.hpp>
#include <kanexpr/compiled/function.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/numeric/impulses.hpp>
#include <kanexpr/simulations/events/event.hpp>
#include <kanexpr/simulations/settings.hpp>

#include <Eigen/Core>
#include <stdexcept>
#include <string>

namespace kanexpr {

/// Newton's law of impact as the handler of events: `impact<System, gap>(0.8)`. The gaps are expressions of
/// the configuration that are positive while bodies are apart. When a gap closes, the speeds change by
/// impulses that act through the mass matrix and the constraints, and contact velocities v become −e v. If
/// several gaps are closed at the time, all of them receive impulses that push, and the kinetic energy does
/// not increase.
///
/// A body that bounces comes to rest after infinitely many impacts in a finite time; nothing supports it
/// then. If all approach speeds are below `rest_speed`, the simulation stops at that time. Without a rest
/// speed, it ends with the failure "events occur faster and faster".
template <class System, auto... gaps>
class impact {
  using eom = equations_of_motion<System>;

public:
  /// The restitution e is in [0, 1]; otherwise the first impact ends the simulation with a failure. A gap is
  /// closed if it is at most `closed`.
  explicit impact(double restitution, double rest_speed = 0, double closed = 1e-9)
      : restitution_(restitution), rest_speed_(rest_speed), closed_(closed) {}

  after_event operator()(moment<System>& now) const {
    static_assert(sizeof...(gaps) > 0 && sizeof...(gaps) <= 12);
    static_assert(compiled::survey_of<System>.nonlinear_constraints == 0,
                  "impact requires constraints that are linear in the speeds, because impulses along their "
                  "derivatives do not preserve others");
    if (!(restitution_ >= 0 && restitution_ <= 1))
      throw std::domain_error("the restitution " + std::to_string(restitution_) + " is not in [0, 1]");
    Eigen::MatrixXd contacts(sizeof...(gaps), eom::speeds);
    Eigen::VectorXd offsets(sizeof...(gaps));
    Eigen::Index count = 0;
    (add_if_closed<gaps>(now, contacts, offsets, count), ...);
    if (count == 0) return after_event::go_on;
    contacts.conservativeResize(count, Eigen::NoChange), offsets.conservativeResize(count);
    const Eigen::VectorXd u = now.x.u();
    const Eigen::VectorXd before = contacts * u + offsets;
    if (before.minCoeff() >= 0) return after_event::go_on;
    const Eigen::VectorXd steady = contacts.completeOrthogonalDecomposition().solve(offsets);
    now.x.u() = struck(now, contacts).speeds_after(u + steady, restitution_) - steady;
    return -before.minCoeff() < rest_speed_ ? after_event::stop : after_event::go_on;
  }

private:
  /// Adds the row of the velocity ∂ġ/∂u u + offset of a gap g; it is linear in the speeds.
  template <auto gap>
  void add_if_closed(const moment<System>& now, Eigen::MatrixXd& contacts, Eigen::VectorXd& offsets,
                     Eigen::Index& count) const {
    using distance = out_of_line<function<System, gap>>;
    using rate = out_of_line<function<System, derivative(gap)>>;
    if (!(distance{}(now.t, now.x, now.p, now.r) <= closed_)) return;
    state<System> x = now.x;
    x.u().setZero();
    const double at_rest = rate{}(now.t, x, now.p, now.r);
    offsets[count] = at_rest;
    for (Eigen::Index i = 0; i < eom::speeds; ++i) {
      x.u().setZero();
      x.u()[i] = 1;
      contacts(count, i) = rate{}(now.t, x, now.p, now.r) - at_rest;
    }
    ++count;
  }

  static numeric::struck_contacts struck(const moment<System>& now, const Eigen::MatrixXd& contacts) {
    using quantity = mechanics::quantity;
    using mass = out_of_line<function<System, quantity::unreduced_mass_matrix>>;
    constexpr int fixed = compiled::result_shape<System, quantity::constraint_jacobian>::rows;
    Eigen::MatrixXd constraints(fixed, eom::speeds);
    if constexpr (fixed > 0)
      constraints =
          out_of_line<function<System, quantity::constraint_jacobian>>{}(now.t, now.x, now.p, now.r);
    return {mass{}(now.t, now.x, now.p, now.r), constraints, contacts};
  }

  double restitution_, rest_speed_, closed_;
};

} // namespace kanexpr
