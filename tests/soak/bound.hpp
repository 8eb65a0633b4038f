// A random mechanism with random constraints in random units, compared with the equations with multipliers in
// the original units.
#pragma once

#include "hostile.hpp"
#include "mechanics/random/bound_mechanism.hpp"
#include "mechanics/random/constrained_recipe.hpp"
#include "random_units.hpp"

namespace soak {

class bound {
public:
  explicit bound(unsigned seed) : d_(seed + 77), expected_(seed, true) {}

  bool is_regular() const { return expected_.regular; }

  void run(errors& found, const wanted& w) {
    const recipe::units in = any_units(d_, w);
    recipe::in_units changed(expected_.m, in, any_constants(d_));
    std::vector<recipe::constraint> bounds;
    std::vector<double> rows;
    for (const recipe::constraint& c : expected_.bounds) {
      const double row = any_power(d_, w);
      bounds.push_back(changed.converted(c, row));
      rows.push_back(changed.of_row(c, row));
    }
    recipe::mechanism m = changed.result();
    recipe::bound_mechanism built(m, bounds);
    found.expect(built.b.check().view().empty(), std::string(built.b.check().view()));
    if (!found.reason().empty()) return;
    built.derived.constrain();
    found.expect(built.derived.mistake().view().empty(), std::string(built.derived.mistake().view()));
    if (!found.reason().empty()) return;
    result_of rates(built.b, built.derived);
    rates.at(m);
    compare(built, changed, in, rows, rates.status(), found);
    if (!w.hostile_states) return;
    hostile_states hostile(m, changed, d_);
    hostile.visit(built.b, built.derived, found);
    hostile_visited = hostile.visited, hostile_refused = hostile.refused;
  }

  long hostile_visited = 0, hostile_refused = 0;

private:
  void compare(recipe::bound_mechanism& built, const recipe::in_units& changed, const recipe::units& in,
               const std::vector<double>& rows, const kanexpr::status& told, errors& found) {
    using elimination::product;
    using elimination::transposed;
    using kanexpr::mechanics::quantity;
    using recipe::columns_of;
    using recipe::Index;
    using recipe::MatrixXd;
    using recipe::VectorXd;
    const auto &d = built.derived.speeds().dependent, &i = built.derived.speeds().independent;
    found.expect(d.size() == expected_.linear.jacobian.rows(),
                 "the constraints have another number of dependent speeds");
    if (!found.reason().empty()) return;
    const std::vector<double>& u = changed.speeds();
    const std::vector<double> dependent = some_of(u, d), forces = inverse(some_of(u, i));
    const MatrixXd &j = expected_.linear.jacobian, &mass = expected_.free.mass_matrix;
    found.compare("Jacobian", in_old_units(built.found(quantity::constraint_jacobian), rows, inverse(u)), j,
                  1);

    const elimination::solved square =
        elimination::solve(columns_of(j, d), MatrixXd::Identity(d.size(), d.size()));
    if (square.least_pivot == 0) return; // the same choice for any values of the symbols
    const MatrixXd& inverse_of_square = square.x;
    const MatrixXd a = -product(inverse_of_square, columns_of(j, i));
    const VectorXd rest = -product(inverse_of_square, expected_.linear.bias);
    const double conditioning = 1 + inverse_of_square.norm() * j.norm();
    if (!(conditioning < most_conditioning)) return;
    found.expect(static_cast<bool>(told), "refused a regular state: " + told.cause());
    if (!told) return; // the numbers are meaningless
    found.compare("dependency", in_old_units(built.found(quantity::dependency), dependent, forces), a,
                  conditioning);
    found.compare("acceleration bias",
                  in_old_units(built.found(quantity::acceleration_bias), dependent, {}, 1 / in.time), rest,
                  conditioning);

    MatrixXd lift = MatrixXd::Zero(mass.rows(), i.size()); // u̇ = lift u̇_i + moved
    VectorXd moved = VectorXd::Zero(mass.rows());
    for (int r = 0; r < i.size(); ++r) lift(i[r], r) = 1;
    for (int r = 0; r < d.size(); ++r) lift.row(d[r]) = a.row(r), moved(d[r]) = rest(r);
    const MatrixXd down = transposed(lift);
    const double size = lift.norm() * lift.norm() * (mass.norm() + expected_.free.force_scale);
    found.compare("reduced mass matrix",
                  in_old_units(built.found(quantity::mass_matrix), forces, forces, in.energy()),
                  product(down, product(mass, lift)), size);
    found.compare("reduced forcing", in_old_units(built.found(quantity::forcing), forces, {}, in.power()),
                  product(down, expected_.free.forcing - product(mass, moved)), size * (1 + moved.norm()));

    const VectorXd udot = in_old_units(built.found(quantity::udot), u, {}, 1 / in.time),
                   lambda = in_old_units(built.found(quantity::multipliers), inverse(rows), {}, in.power());
    const double accelerations = conditioning * (1 + udot.norm()), force = 1 + expected_.free.force_scale +
                                                                           mass.norm() * accelerations +
                                                                           conditioning * lambda.norm();
    found.compare("constraints on accelerations", product(j, udot), -expected_.linear.bias,
                  j.norm() * accelerations);
    found.compare("equations with multipliers", product(mass, udot) - product(transposed(j), lambda),
                  expected_.free.forcing, force);
    found.compare("udot with constraints", udot, expected_.udot, accelerations);
    const VectorXd speeds = recipe::speeds_of(expected_.m);
    found.compare("dependent speeds", in_old_units(built.found(quantity::dependent_speeds), dependent),
                  recipe::entries_of(speeds, d), conditioning * (1 + speeds.norm()));
  }

  /// The reduced mass matrix is conditioned like its square; beyond this limit, the status may call it
  /// singular.
  static constexpr double most_conditioning = 2e4;

  dice d_;
  recipe::constrained expected_;
};

} // namespace soak
