// Derivatives of compiled functions by complex steps: exact up to rounding, and independent of the library's
// derivatives.
#pragma once

#include "no_heap.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/kanexpr.hpp>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <complex>
#include <random>
#include <vector>

namespace step_checks {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The arguments of a function.
template <class System>
struct point {
  double t = 0;
  kanexpr::state<System> x;
  kanexpr::parameter_values<System> p;
  kanexpr::input_values<System> r = kanexpr::input_values<System>::Zero();
};

// Numbers between −reach and reach.
inline VectorXd random_numbers(std::mt19937_64& source, Eigen::Index count, double reach) {
  std::uniform_real_distribution<double> unit(-reach, reach);
  return VectorXd::NullaryExpr(count, [&] { return unit(source); });
}

// Coordinates that differ from `around` by up to `reach` and speeds by up to 2; inputs that differ from 1 by
// up to 2, and parameters by up to a third.
template <class System>
point<System> random_point(std::mt19937_64& source, const point<System>& around, double reach) {
  constexpr int n = kanexpr::equations_of_motion<System>::coordinates;
  point<System> at = around;
  at.t += random_numbers(source, 1, 1)(0);
  at.x.head(n) += random_numbers(source, n, reach);
  at.x.tail(at.x.size() - n) += random_numbers(source, at.x.size() - n, 2);
  at.p.array() *= 1 + random_numbers(source, at.p.size(), 1).array() / 3;
  at.r.array() += 1 + random_numbers(source, at.r.size(), 2).array();
  return at;
}

// Treats every parameter as 1.
template <class System>
point<System> plain_point() {
  point<System> at;
  at.p.setOnes();
  return at;
}

// [∂f/∂x ∂f/∂r].
template <class System, class Function>
MatrixXd derivatives(Function f, const point<System>& at) {
  using complex = std::complex<double>;
  constexpr double step = 1e-30;
  kanexpr::state<System, complex> x(at.x.template cast<complex>());
  kanexpr::input_values<System, complex> r(at.r.template cast<complex>());
  MatrixXd all;
  for (Eigen::Index j = 0; j < x.size() + r.size(); ++j) {
    complex& moved = j < x.size() ? x(j) : r(j - x.size());
    const complex value = moved;
    moved += complex(0, step);
    const Eigen::VectorXcd there = f(at.t, x, at.p, r);
    moved = value;
    if (j == 0) all.resize(there.size(), x.size() + r.size());
    all.col(j) = there.imag() / step;
  }
  return all;
}

// [∂ẋ/∂x ∂ẋ/∂r] as computed by the library.
template <class System>
MatrixXd jacobian(const point<System>& at) {
  const auto [by_state, by_inputs] = [&] {
    no_heap::guard guard;
    return kanexpr::linearization<System>::jacobian(at.t, at.x, at.p, at.r);
  }();
  MatrixXd all(by_state.rows(), by_state.cols() + by_inputs.cols());
  all << by_state, by_inputs;
  return all;
}

// At random states, which need not satisfy any constraints.
template <class System>
void jacobian_is_that_of_rhs(const point<System>& around = plain_point<System>(), double reach = 1) {
  constexpr auto rhs = kanexpr::equations_of_motion<System>::rhs;
  std::mt19937_64 source(11);
  int compared = 0;
  for (int tried = 0; compared < 100 && tried < 400; ++tried) {
    const point<System> at = random_point(source, around, reach);
    const MatrixXd expected = derivatives(rhs, at);
    if (!expected.allFinite() || expected.cwiseAbs().maxCoeff() > 1e3) continue; // nearly singular
    EXPECT_LE((jacobian(at) - expected).norm(), 1e-11 * expected.norm());
    ++compared;
  }
  EXPECT_EQ(compared, 100);
}

// At states that satisfy the constraints: the dependent entries follow changes of the independent ones and of
// the inputs.
template <class System>
void reduces_to_explicit_form(const point<System>& around) {
  using eom = kanexpr::equations_of_motion<System>;
  using lin = kanexpr::linearization<System>;
  std::mt19937_64 source(5);
  int compared = 0;
  for (int tried = 0; compared < 100 && tried < 1000; ++tried) {
    point<System> at = random_point(source, around, 0.3);
    if (!kanexpr::assemble<System>(at.x, at.p, at.r, at.t)) continue;
    const MatrixXd residual = derivatives(eom::constraint_residual, at), whole = jacobian(at);
    std::vector<Eigen::Index> free, bound;
    for (int j = 0; j < whole.cols(); ++j)
      (j < at.x.size() && lin::known.dependent[j] ? bound : free).push_back(j);
    const auto size = static_cast<Eigen::Index>(free.size());
    MatrixXd follows = MatrixXd::Zero(whole.cols(), size);
    follows(free, Eigen::all).setIdentity();
    follows(bound, Eigen::all) =
        -MatrixXd(residual(Eigen::all, bound)).lu().solve(MatrixXd(residual(Eigen::all, free)));
    const MatrixXd expected = whole(lin::places, Eigen::all) * follows;
    if (expected.cwiseAbs().maxCoeff() > 1e3) continue; // nearly singular
    const auto [A, B] = lin::explicit_form(at.t, at.x, at.p, at.r);
    MatrixXd found(expected.rows(), size);
    found << A, B;
    EXPECT_LE((found - expected).norm(), 1e-11 * expected.norm());
    ++compared;
  }
  EXPECT_EQ(compared, 100);
}

} // namespace step_checks
