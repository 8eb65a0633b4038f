// builds: clang++
// Random mechanisms at states that violate all constraints: the derivatives of all rates with respect to the
// whole state and the inputs, compared with complex steps, and the forces of all speeds, compared with the
// multipliers.
#include "mechanics/random/bound_mechanism.hpp"
#include "mechanics/random/random_mechanism.hpp"
#include "mechanics/random/random_springs.hpp"

#include <kanexpr/lower/complex_math.hpp>

#include <gtest/gtest.h>

#include <complex>

namespace {

using complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::mechanics::quantity;

// [q; u; r] of a mechanism.
std::vector<complex> arguments(const recipe::mechanism& m) {
  std::vector<complex> all;
  for (const std::vector<double>* part : {&m.q, &m.u, &m.r})
    all.insert(all.end(), part->begin(), part->end());
  return all;
}

MatrixXd by_complex_steps(recipe::bound_mechanism& one) {
  constexpr double step = 1e-30;
  const recipe::mechanism& m = one.m;
  const auto rhs = one.derived.get(quantity::rhs);
  kanexpr::runtime::interpreter<complex> code(
      kanexpr::lower::tape_of(one.b.graph(), kanexpr::symbolic::nodes_of(rhs.entries)));
  std::vector<complex> at = arguments(m);
  Eigen::VectorXcd there(rhs.rows);
  MatrixXd out(rhs.rows, static_cast<Index>(at.size()));
  for (std::size_t j = 0; j < at.size(); ++j) {
    at[j] += complex(0, step);
    code.evaluate(
        [&](const kanexpr::lower::load& l) -> complex {
          using kanexpr::symbolic::symbol_kind;
          const auto i = static_cast<std::size_t>(l.position);
          switch (l.from) {
          case symbol_kind::time: return m.t;
          case symbol_kind::parameter: return m.parameters[i];
          case symbol_kind::coordinate: return at[i];
          case symbol_kind::speed: return at[m.q.size() + i];
          default: return at[m.q.size() + m.u.size() + i];
          }
        },
        there.data());
    at[j] = at[j].real();
    out.col(static_cast<Index>(j)) = there.imag() / step;
  }
  return out;
}

MatrixXd jacobian(recipe::bound_mechanism& one) {
  const MatrixXd by_state = one.found(quantity::state_jacobian),
                 by_inputs = one.found(quantity::input_jacobian);
  MatrixXd all(by_state.rows(), by_state.cols() + by_inputs.cols());
  all << by_state, by_inputs;
  return all;
}

// The derivatives along the unit quaternions. For other norms, no rotation is defined, and the rates have no
// mechanical meaning.
MatrixXd along_rotations(const recipe::mechanism& m, MatrixXd derivatives) {
  for (const recipe::frame& f : m.frames) {
    if (f.how != recipe::turn::quaternion) continue;
    const Eigen::Vector4d e(&m.q[static_cast<std::size_t>(f.quaternion)]);
    auto by_quaternion = derivatives.middleCols<4>(f.quaternion);
    by_quaternion -= (by_quaternion * e * e.transpose() / e.squaredNorm()).eval();
  }
  return derivatives;
}

// The remainder of F_r + F_r* + Jᵀ λ along a motion, relative to its largest term.
double imbalance(recipe::bound_mechanism& one) {
  const VectorXd udot = one.found(quantity::udot);
  const VectorXd force = number(one.m, one.derived.get(quantity::unreduced_forces),
                                std::vector<double>(udot.begin(), udot.end()));
  EXPECT_EQ(force.size(), udot.size());
  const VectorXd held =
      one.found(quantity::constraint_jacobian).transpose() * one.found(quantity::multipliers);
  return (force + held).norm() / (held.norm() + one.found(quantity::forcing).norm());
}

TEST(free_directions, differentiate_the_whole_right_side) {
  int compared = 0, constrained = 0;
  for (unsigned seed = 0; compared < 100 && seed < 2000 && !HasFailure(); ++seed) {
    SCOPED_TRACE("mechanism " + std::to_string(seed));
    recipe::mechanism m = recipe::generator(seed, false).run();
    recipe::random_springs(m, seed).hang();
    std::vector<recipe::constraint> bounds;
    if (seed % 3 != 0 && m.u.size() > 1) bounds = recipe::random_constraints(m, seed).run();
    recipe::bound_mechanism one(m, bounds);
    one.derived.constrain();
    if (one.derived.mistake()) continue;
    const MatrixXd expected = along_rotations(m, by_complex_steps(one));
    if (!expected.allFinite() || expected.cwiseAbs().maxCoeff() > 1e3) continue; // nearly singular
    ++compared;
    if (!bounds.empty()) ++constrained;
    EXPECT_LE((along_rotations(m, jacobian(one)) - expected).norm(), 3e-10 * (1 + expected.norm()));
    EXPECT_LE(imbalance(one), 1e-12);
  }
  EXPECT_EQ(compared, 100);
  EXPECT_GT(constrained, 40);
}

} // namespace
