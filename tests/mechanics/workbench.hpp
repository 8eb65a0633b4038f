// Three angles and systems that can be built from them, with numeric values.
#pragma once

#include "numbers_of.hpp"

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <limits>
#include <string>
#include <vector>

namespace workbench {

namespace mechanics = kanexpr::mechanics;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::runtime::vector;
using kanexpr::symbolic::expression;
using mechanics::quantity;

// Three angles with their rates as speeds, a particle that depends on all three, and numeric values for them.
struct bench : builder {
  expression q[3], u[3];
  // the first three are those above; a test with more of them specifies their number
  double q_now[5]{0.3, -0.8, 1.1, 0.2, -0.1}, u_now[5]{0.7, -1.3, 0.4}, udot_now[5]{0.2, 0.9, -0.5};
  double t_now = 0.6;
  std::vector<double> r_now; // the inputs
  frame_id n = inertial_frame();
  point_id o;

  explicit bench(bool rates_as_speeds = true) : builder("N") {
    for (int i = 0; i < 3; ++i) {
      q[i] = coordinate("q" + std::to_string(i));
      u[i] = speed("u" + std::to_string(i));
    }
    for (int i = 0; i < 3 && rates_as_speeds; ++i) kinematic_equation(dot(q[i]) - u[i]);
    o = origin("O");
    if (rates_as_speeds) particle("ballast", offset("B", o, along(n, q[0], q[1], q[2])), number(1));
  }

  MatrixXd numbers(const kanexpr::symbolic::matrix& wanted) {
    const auto value_of = [&](const kanexpr::lower::load& l) {
      using kanexpr::symbolic::symbol_kind;
      if (l.from == symbol_kind::coordinate) return q_now[l.position];
      if (l.from == symbol_kind::speed) return u_now[l.position];
      if (l.from == symbol_kind::speed_rate) return udot_now[l.position];
      if (l.from == symbol_kind::input) return r_now.at(static_cast<std::size_t>(l.position));
      if (l.from == symbol_kind::time) return t_now;
      return std::numeric_limits<double>::quiet_NaN();
    };
    return numbers_of(wanted, value_of);
  }
  Vector3d in_ground(const vector& v) { return in_axes(n, v); }
  Vector3d in_axes(frame_id f, const vector& v) {
    const mechanics::components c = mechanics::express(mechanism(), v, place(f));
    kanexpr::symbolic::matrix m(graph(), 3, 1);
    for (int i = 0; i < 3; ++i) m.entries[i] = c[i];
    return numbers(m);
  }
  Matrix3d to_ground(frame_id f) {
    Matrix3d r;
    for (int i = 0; i < 3; ++i) r.col(i) = in_ground(along(f, i == 0, i == 1, i == 2));
    return r;
  }
};

inline void expect_equal(const MatrixXd& found, const MatrixXd& expected) {
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-11 * (1 + expected.cwiseAbs().maxCoeff()))
      << "found\n"
      << found << "\nexpected\n"
      << expected;
}

} // namespace workbench
