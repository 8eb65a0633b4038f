#include "systems/interpreted.hpp"

#include "systems/hand_written.hpp"

#include <algorithm>

namespace check {

namespace {

using hand_written::pick;
using kanexpr::mechanics::quantity;

std::vector<std::string> called(const kanexpr::base::sequence<kanexpr::symbolic::expression>& symbols) {
  std::vector<std::string> names;
  for (const auto& each : symbols) names.push_back(kanexpr::symbolic::print(each));
  return names;
}

VectorXd joined(const VectorXd& a, const VectorXd& b) {
  VectorXd both(a.size() + b.size());
  both << a, b;
  return both;
}

// Quantities that the reference has in addition to the speeds do not matter.
VectorXd independent(const VectorXd& speeds, const std::vector<std::string>& names,
                     const std::vector<std::string>& dependent) {
  std::vector<std::string> free;
  for (const std::string& name : names)
    if (std::find(dependent.begin(), dependent.end(), name) == dependent.end()) free.push_back(name);
  return pick(free, names, speeds);
}

} // namespace

void interpreted_against_oracle(kanexpr::model model, const std::string& name, bool has_gravity) {
  SCOPED_TRACE(name);
  ASSERT_EQ(model.mistake(), "");
  const oracle::system reference = oracle::load(name);
  const auto& m = model.mechanism();
  const auto q = called(m.coordinates), u = called(m.speeds), r_names = called(m.inputs);
  const auto parameters = called(m.parameters);
  VectorXd p(m.parameters.size());
  for (int i = 0; i < p.size(); ++i) p(i) = reference.parameters.at(parameters[static_cast<std::size_t>(i)]);

  const auto function = [&](quantity wanted) { return model.function(model.get(wanted)); };
  auto mass_matrix = function(quantity::mass_matrix), forcing = function(quantity::forcing);
  auto qdot = function(quantity::qdot), udot = function(quantity::udot), rhs = function(quantity::rhs);
  auto kinetic = function(quantity::kinetic_energy), potential = function(quantity::potential_energy);
  auto inertia = function(quantity::inertia_forces), active = function(quantity::active_forces);
  auto gap = function(quantity::configuration_residual), slip = function(quantity::velocity_residual);

  EXPECT_EQ(reference.states.size(), 20u);
  for (const oracle::state& s : reference.states) {
    const VectorXd x = joined(pick(q, reference.q, s.q), pick(u, reference.u, s.u));
    const VectorXd r = pick(r_names, reference.r, s.r);
    const VectorXd rates = pick(q, reference.q, s.qdot), accelerations = pick(u, reference.u, s.udot);
    EXPECT_TRUE(oracle::close(qdot(x, p, r), rates, 1e-12));
    EXPECT_TRUE(oracle::close(udot(x, p, r), accelerations, 1e-12));
    EXPECT_TRUE(udot.status()) << udot.status().cause();
    EXPECT_TRUE(oracle::close(rhs(x, p, r), joined(qdot(x, p, r), udot(x, p, r)), 1e-15));

    const MatrixXd M = mass_matrix(x, p, r);
    const VectorXd f = forcing(x, p, r);
    const VectorXd free = independent(accelerations, u, reference.u_dependent);
    if (reference.u_dependent.empty() && s.mass_matrix.size() > 0) {
      EXPECT_TRUE(oracle::close(M, s.mass_matrix, 1e-12));
      EXPECT_TRUE(oracle::close(f, s.forcing, 1e-12));
    }
    EXPECT_TRUE(oracle::close(M * free, f, 1e-11));
    EXPECT_TRUE(oracle::close(M.transpose(), M, 1e-13));

    if (s.kinetic_energy) {
      EXPECT_NEAR(kinetic(x, p, r)(0, 0), *s.kinetic_energy, 1e-12 * *s.kinetic_energy);
    }
    if (has_gravity && s.potential_energy) {
      EXPECT_NEAR(potential(x, p, r)(0, 0), *s.potential_energy, 1e-12 * std::abs(*s.potential_energy));
    }

    const VectorXd loads = active(x, p, r), resistance = inertia(0.0, x, p, r, accelerations);
    EXPECT_LE((loads + resistance).cwiseAbs().maxCoeff(),
              1e-11 * (loads.cwiseAbs().maxCoeff() + f.cwiseAbs().maxCoeff()));

    EXPECT_EQ(gap(x, p, r).size(), s.configuration_residual.size());
    EXPECT_EQ(slip(x, p, r).size(), s.velocity_residual.size());
    if (gap(x, p, r).size() > 0) {
      EXPECT_LE(gap(x, p, r).cwiseAbs().maxCoeff(),
                1e-15 * (1 + x.head(m.coordinates.size()).cwiseAbs().maxCoeff()));
    }
    if (slip(x, p, r).size() > 0) {
      EXPECT_LE(slip(x, p, r).cwiseAbs().maxCoeff(),
                1e-15 * (1 + x.tail(m.speeds.size()).cwiseAbs().maxCoeff()));
    }
  }
}

void interpreted_robot_against_oracle(kanexpr::model model, const std::string& name,
                                      seen_by_reference seen_by) {
  SCOPED_TRACE(name);
  ASSERT_EQ(model.mistake(), "");
  auto mass_matrix = model.function(model.mass_matrix()), forcing = model.function(model.forcing());
  auto udot = model.function(model.udot());
  const oracle::robot reference = oracle::load_robot(name);
  const VectorXd none, at_rest = VectorXd::Zero(model.mechanism().inputs.size());
  EXPECT_EQ(reference.states.size(), 20u);
  for (const oracle::robot_state& s : reference.states) {
    const convention seen = seen_by(s.q, s.u);
    const VectorXd x = joined(s.q, seen.turn.transpose() * s.u), motors = s.torque.tail(at_rest.size());
    const robot_results results{mass_matrix(x, none, motors), forcing(x, none, at_rest),
                                forcing(x, none, motors), udot(x, none, motors)};
    EXPECT_TRUE(udot.status()) << udot.status().cause();
    expect_reference(results, s, seen, motors.size());
  }
}

} // namespace check
