// builds: clang++
// Every force element: its power by its own law against that of its generalized forces, its energy at random
// states and along random motions, and its derivatives against complex steps.
#include "elements_at_joints.hpp"
#include "elements_of_muscles.hpp"
#include "elements_of_tyres.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <random>

namespace {

using namespace elements;
using Eigen::MatrixXd;
using kanexpr::model;
using kanexpr::symbolic::matrix;
using mechanics::quantity;

const VectorXd nothing(0);

std::vector<element> all_elements() {
  std::vector<element> all;
  for (const auto& rows :
       {along_pathways(), between_bodies(), in_contacts(), at_joints(), on_wheels(), of_muscles()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

/// The derivative of an expression along the motion.
expression rate_of(model& m, const matrix& rates, expression value) {
  expression sum = value.number(kanexpr::symbolic::exactly(0));
  int row = 0;
  for (const auto* list : {&m.mechanism().coordinates, &m.mechanism().speeds})
    for (const expression& e : *list)
      sum += kanexpr::symbolic::differentiate(value, e) * rates.entries[row++];
  return sum;
}

/// An element with everything that is known of it, as functions of the state.
class examined {
public:
  struct values {
    VectorXd rates;
    double power = 0;             ///< by the element's own law
    double by_forces = 0;         ///< of the generalized forces
    double by_motion = 0;         ///< the rate of the kinetic energy
    double storing = 0;           ///< the rate of the energy of the element
    double energy = 0, scale = 0; ///< the whole energy, and the size of the terms of the power
  };

  explicit examined(const element& e) : power_(e.power), made_(e.build()), all_(evaluated()) {}

  model& derived() { return made_.model; }
  Eigen::Index size() { return made_.model.rhs().rows; }

  values at(const VectorXd& x) {
    const MatrixXd found = all_(x);
    const Eigen::Index n = x.size(), k = static_cast<Eigen::Index>(made_.measured.size());
    const auto row = [&](Eigen::Index i) { return found(n + k + i, 0); };
    return {found.topRows(n), power_(found.middleRows(n, k).col(0)), row(0), row(1), row(2), row(3), row(4)};
  }

private:
  kanexpr::runtime::interpreted<double> evaluated() {
    model& m = made_.model;
    EXPECT_EQ(m.mistake(), "");
    const matrix rates = m.rhs(), forces = m.get(quantity::load_compensation);
    const expression zero = m.mechanism().zero();
    expression stored = zero;
    if (has_potential_energy(m)) stored += m.get(quantity::potential_energy).entries[0];
    if (made_.stored.is_given()) stored += made_.stored;
    const expression kinetic = m.get(quantity::kinetic_energy).entries[0];
    expression power = zero, scale = m.mechanism().one();
    for (int i = 0; i < m.mechanism().speeds_of_motion(); ++i) {
      const expression term = forces.entries[i] * m.mechanism().speeds[i];
      power += -term, scale += term * term;
    }
    matrix all = rates;
    for (const expression& e : made_.measured) all.entries.push(e);
    for (const expression& e :
         {power, rate_of(m, rates, kinetic), rate_of(m, rates, stored), kinetic + stored, sqrt(scale)})
      all.entries.push(e);
    all.rows = all.entries.size();
    return m.function(all);
  }
  static bool has_potential_energy(model& m) {
    bool any = false;
    m.system().loads.each(
        [&](const auto& load, int) { any = any || requires { load.potential_energy(m.mechanism()); }; });
    return any;
  }

  std::function<double(const VectorXd&)> power_;
  mechanism_with_element made_;
  kanexpr::runtime::interpreted<double> all_;
};

VectorXd random_numbers(std::mt19937_64& source, Eigen::Index size) {
  std::uniform_real_distribution<double> value(-1.2, 1.2);
  return VectorXd::NullaryExpr(size, [&] { return value(source); });
}
VectorXd random_state(std::mt19937_64& source, const element& e, Eigen::Index size) {
  VectorXd state = random_numbers(source, size);
  e.settle(state);
  return state;
}

TEST(elements, have_the_power_of_their_law_and_create_no_energy) {
  for (const element& e : all_elements()) {
    SCOPED_TRACE(e.name);
    examined of(e);
    if (::testing::Test::HasFailure()) return;
    std::mt19937_64 source(5);
    int acting = 0;
    for (int i = 0; i < 1000; ++i) {
      const VectorXd x = random_state(source, e, of.size());
      const examined::values v = of.at(x);
      if (!v.rates.allFinite()) continue; // no pathway around the surface
      const double scale = v.scale * (1 + v.rates.norm());
      acting += std::abs(v.power) > 1e-6;
      ASSERT_NEAR(v.power, v.by_forces, 1e-12 * scale) << x.transpose();
      ASSERT_NEAR(v.by_motion, v.by_forces, 1e-12 * scale) << x.transpose();
      if (e.is == nature::conservative) {
        ASSERT_NEAR(v.power, -v.storing, 1e-12 * scale) << x.transpose();
      }
      if (e.is == nature::dissipative) {
        ASSERT_LE(v.power + v.storing, 1e-12 * scale) << x.transpose();
      }
    }
    if (e.name != "rotor of a pin") {
      EXPECT_GT(acting, 200);
    }
  }
}

// The energy changes by the integral of the losses, and never grows. Steps are as long as fast states permit.
void expect_no_energy_along_motion(examined& of, VectorXd x) {
  const auto loss = [](const examined::values& v) { return v.power + v.storing; };
  examined::values k1 = of.at(x);
  const double start = k1.energy;
  double lost = 0, least = start, h = 2e-4;
  for (double t = 0; t < 0.05;) {
    const auto k2 = of.at(x + h / 2 * k1.rates), k3 = of.at(x + h / 2 * k2.rates);
    const double of_state = (k3.rates - k2.rates).norm() / (1 + x.norm()),
                 of_energy = std::abs(loss(k3) - loss(k2)) / (1 + start), change = h * (of_state + of_energy);
    if (change > 1e-6) {
      h /= 2;
      ASSERT_GT(h, 1e-10) << t;
      continue;
    }
    const auto k4 = of.at(x + h * k3.rates);
    x += h / 6 * (k1.rates + 2 * k2.rates + 2 * k3.rates + k4.rates);
    lost += h / 6 * (loss(k1) + 2 * loss(k2) + 2 * loss(k3) + loss(k4));
    t += h;
    k1 = of.at(x);
    if (!std::isfinite(k1.energy)) return; // the pathway left its surface
    ASSERT_NEAR(k1.energy - start, lost, 1e-9 * (1 + start)) << t;
    ASSERT_LE(k1.energy, least + 1e-9 * (1 + start)) << t;
    least = std::fmin(least, k1.energy);
    if (change < 1e-7) h = std::fmin(1.5 * h, 5e-4);
  }
}

TEST(elements, create_no_energy_along_random_motions) {
  constexpr int motions = 3;
  for (const element& e : all_elements()) {
    if (e.is == nature::driven) continue;
    SCOPED_TRACE(e.name);
    examined of(e);
    std::mt19937_64 source(9);
    for (int motion = 0; motion < motions; ++motion) {
      SCOPED_TRACE(motion);
      VectorXd x = random_state(source, e, of.size());
      while (!of.at(x).rates.allFinite()) x = random_state(source, e, of.size());
      expect_no_energy_along_motion(of, x);
    }
  }
}

TEST(elements, have_exact_derivatives_to_the_second_order) {
  using complex = std::complex<double>;
  for (const element& e : all_elements()) {
    SCOPED_TRACE(e.name);
    mechanism_with_element made = e.build();
    model& m = made.model;
    ASSERT_EQ(m.mistake(), "");
    auto rhs = m.function<complex>(m.rhs());
    auto jacobian = m.function<complex>(m.get(quantity::state_jacobian));
    auto hessian = m.function(m.get(quantity::weighted_hessian));
    auto in_double = m.function(m.rhs());
    auto in_float = m.function<float>(m.rhs());
    const Eigen::Index n = m.rhs().rows;
    std::mt19937_64 source(21);
    for (int k = 0; k < 4; ++k) {
      const VectorXd x = random_state(source, e, n), weights = random_numbers(source, n);
      const MatrixXd first = Eigen::MatrixXcd(jacobian(Eigen::VectorXcd(x))).real();
      const MatrixXd second = hessian(0, x, nothing, nothing, weights);
      const VectorXd rates = in_double(x);
      if (!rates.allFinite()) continue; // no pathway around the surface
      ASSERT_TRUE(first.allFinite()) << x.transpose();
      ASSERT_TRUE(second.allFinite()) << x.transpose();
      for (Eigen::Index j = 0; j < n; ++j) {
        Eigen::VectorXcd aside = x;
        aside[j] += complex(0, 1e-30);
        const VectorXd column = Eigen::VectorXcd(rhs(aside)).imag() / 1e-30;
        ASSERT_LT((column - first.col(j)).norm(), 1e-10 * (1 + first.norm())) << j;
        const VectorXd bent = (Eigen::MatrixXcd(jacobian(aside)).imag() / 1e-30).transpose() * weights;
        ASSERT_LT((bent - second.col(j)).norm(), 1e-10 * (1 + second.norm())) << j;
      }
      const VectorXd single = Eigen::VectorXf(in_float(Eigen::VectorXf(x.cast<float>()))).cast<double>();
      ASSERT_LT((single - rates).norm(), 1e-3 * (1 + rates.norm()));
    }
  }
}

} // namespace
