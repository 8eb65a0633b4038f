// A random mechanism without constraints in random units, compared with the Newton-Euler equations in the
// original units.
#pragma once

#include "hostile.hpp"
#include "mechanics/random/newton_euler_dynamics.hpp"
#include "mechanics/random/random_mechanism.hpp"
#include "mechanics/random/random_springs.hpp"
#include "random_units.hpp"

namespace soak {

class tree {
public:
  explicit tree(unsigned seed)
      : d_(seed + 77), base_(mechanism_of(seed)), expected_(newton_euler::evaluate(base_)) {}

  // If a declared velocity removes all mass from a speed, there is no mechanism.
  static bool is_solvable(const Eigen::MatrixXd& mass_matrix) {
    Eigen::MatrixXd left = mass_matrix;
    double least = 1e300, most = 0;
    for (Eigen::Index k = 0; k < left.rows(); ++k) {
      least = std::min(least, left(k, k)), most = std::max(most, left(k, k));
      for (Eigen::Index i = k + 1; i < left.rows(); ++i) {
        const double factor = left(i, k) / left(k, k);
        for (Eigen::Index j = k; j < left.cols(); ++j) left(i, j) -= factor * left(k, j);
      }
    }
    return least > 1e-8 * most;
  }

  bool is_regular() const { return is_solvable(expected_.mass_matrix); }

  void run(errors& found, const wanted& w) {
    const recipe::units in = any_units(d_, w);
    const recipe::in_units changed(base_, in, any_constants(d_));
    const recipe::mechanism& m = changed.result();
    recipe::builder b("N");
    const recipe::building built(m, b);
    found.expect(b.check().view().empty(), std::string(b.check().view()));
    if (!found.reason().empty()) return;
    kanexpr::mechanics::equations derived(b.system());
    compare(m, derived, changed, in, found);
    if (!w.hostile_states) return;
    hostile_states hostile(m, changed, d_);
    hostile.visit(b, derived, found);
    hostile_visited = hostile.visited, hostile_refused = hostile.refused;
  }

  long hostile_visited = 0, hostile_refused = 0;

private:
  static recipe::mechanism mechanism_of(unsigned seed) {
    recipe::mechanism m = recipe::generator(seed, true).run();
    recipe::without_sines_of_lengths(m);
    if (!is_solvable(newton_euler::evaluate(m).mass_matrix)) {
      m = recipe::generator(seed, false).run();
      recipe::without_sines_of_lengths(m);
    }
    recipe::random_springs(m, seed).hang();
    recipe::without_sines_of_lengths(m);
    return m;
  }

  void compare(const recipe::mechanism& m, kanexpr::mechanics::equations& derived,
               const recipe::in_units& changed, const recipe::units& in, errors& found) const {
    using Eigen::MatrixXd;
    using kanexpr::mechanics::quantity;
    const auto value = [&](quantity q) { return recipe::number(m, derived.get(q)); };
    const auto scalar = [](double x) { return MatrixXd::Constant(1, 1, x); };
    const std::vector<double> forces = inverse(changed.speeds());
    const double force = 1 + expected_.force_scale;
    found.compare("qdot", in_old_units(value(quantity::qdot), changed.rates_of_coordinates()), expected_.qdot,
                  1);
    found.compare("mass matrix", in_old_units(value(quantity::mass_matrix), forces, forces, in.energy()),
                  expected_.mass_matrix, 1);
    found.compare("forcing", in_old_units(value(quantity::forcing), forces, {}, in.power()),
                  expected_.forcing, force);
    found.compare("active forces", in_old_units(value(quantity::active_forces), forces, {}, in.power()),
                  expected_.active_forces, force);
    found.compare("kinetic energy", value(quantity::kinetic_energy) / in.energy(),
                  scalar(expected_.kinetic_energy), 1);
    if (m.has_gravity || !m.springs.empty() || !m.twists.empty())
      found.compare("potential energy", value(quantity::potential_energy) / in.energy(),
                    scalar(expected_.potential_energy), 10);
    found.compare("linear momentum", value(quantity::linear_momentum) / (in.mass * in.velocity()),
                  expected_.linear_momentum, 1);
    found.compare("angular momentum", value(quantity::angular_momentum) / (in.inertia() / in.time),
                  expected_.angular_momentum, 1);
    found.compare("center of mass", value(quantity::center_of_mass) / in.length, expected_.center_of_mass, 1);
    if (!is_regular()) return;
    const MatrixXd udot = in_old_units(value(quantity::udot), changed.speeds(), {}, 1 / in.time);
    found.compare("udot", newton_euler::times(expected_.mass_matrix, udot), expected_.forcing,
                  force + expected_.mass_matrix.diagonal().maxCoeff() * udot.norm());
    found.expect(derived.mistake().view().empty(), std::string(derived.mistake().view()));
  }

  dice d_;
  recipe::mechanism base_;
  newton_euler::dynamics expected_;
};

} // namespace soak
