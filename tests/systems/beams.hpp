// Numeric values of models with beams.
#pragma once

#include "numbers_of.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>
#include <kanexpr/numeric/beams/modes.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace beams {

namespace mechanics = kanexpr::mechanics;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using kanexpr::linearization_point;
using kanexpr::base::sequence;
using kanexpr::numeric::beams::ends;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;

// The values of expressions at a state; `by` provides them for coordinates and speeds.
struct values {
  VectorXd q, u;

  MatrixXd of(const kanexpr::symbolic::matrix& wanted) const {
    const auto value_of = [&](const kanexpr::lower::load& l) {
      using kanexpr::symbolic::symbol_kind;
      if (l.from == symbol_kind::coordinate) return q[l.position];
      if (l.from == symbol_kind::speed) return u[l.position];
      return std::numeric_limits<double>::quiet_NaN();
    };
    return numbers_of(wanted, value_of);
  }
  MatrixXd of(const std::vector<expression>& column) const {
    kanexpr::symbolic::matrix m(column[0].owner(), static_cast<int>(column.size()), 1);
    for (int i = 0; i < m.rows; ++i) m(i, 0) = column[static_cast<std::size_t>(i)];
    return of(m);
  }
  Vector3d of(const mechanics::components& c) const { return of(std::vector{c.x, c.y, c.z}); }
};

inline values random_values(int q, int u, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-1, 1);
  const auto draw = [&](int n) {
    return VectorXd(VectorXd::NullaryExpr(n, [&] { return between(random); }));
  };
  values v;
  v.q = draw(q), v.u = draw(u);
  return v;
}

inline void expect_equal(const MatrixXd& found, const MatrixXd& expected, const std::string& what,
                         double tolerance = 1e-12) {
  ASSERT_EQ(found.rows(), expected.rows()) << what;
  ASSERT_EQ(found.cols(), expected.cols()) << what;
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), tolerance * (1 + expected.cwiseAbs().maxCoeff()))
      << what << "\nfound\n"
      << found << "\nexpected\n"
      << expected;
}

// The eigenvalues of a system without parameters, linearized at rest.
inline Eigen::VectorXcd eigenvalues_at_rest(kanexpr::model system) {
  EXPECT_EQ(system.mistake(), "");
  linearization_point rest;
  for (const std::string& name : system.linearize().states()) rest.set(name, 0);
  kanexpr::runtime::linearization linear = system.linearize(rest);
  const kanexpr::symbolic::matrix a = linear.explicit_form().A;
  EXPECT_TRUE(linear) << linear.failures().front();
  return values{}.of(a).eigenvalues();
}

// The positive natural frequencies of an undamped system, lowest first.
inline std::vector<double> frequencies(const kanexpr::model& system) {
  std::vector<double> found;
  for (const std::complex<double>& e : eigenvalues_at_rest(system))
    if (e.imag() > 1e-3) found.push_back(e.imag());
  std::sort(found.begin(), found.end());
  return found;
}

inline void expect_frequencies(const kanexpr::model& system, const std::vector<double>& expected,
                               const std::string& what) {
  const std::vector<double> found = frequencies(system);
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i] / expected[i], 1, 1e-12) << what << ' ' << i;
}

// A builder of beams with three coordinates of a plane body.
struct bench : builder {
  frame_id n = inertial_frame();
  point_id o = origin("O");
  bench() : builder("N") {}

  std::vector<expression> free(const std::string& name, int count) {
    std::vector<expression> q;
    for (int i = 0; i < count; ++i) {
      const std::string index = std::to_string(i + 1);
      q.push_back(coordinate(name + index));
      kinematic_equation(dot(q.back()) - speed("u_" + name + index));
    }
    return q;
  }
};

inline constexpr double length = 1.7, mass_per_length = 0.6, stiffness = 3.1;
inline const double bending_rate = std::sqrt(stiffness / mass_per_length) / (length * length);

inline std::vector<double> rates_of(ends how, int count, const kanexpr::numeric::beams::tip_load& tip = {}) {
  std::vector<double> all;
  for (int n = 1; n <= count; ++n)
    all.push_back(bending_rate * std::pow(kanexpr::numeric::beams::wave_number_of_bending(how, n, tip), 2));
  return all;
}

} // namespace beams
