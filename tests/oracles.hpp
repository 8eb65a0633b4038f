// Reference results for whole systems, computed outside this project; see oracles/README.md.
#pragma once

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <complex>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace oracle {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct state {
  VectorXd q, u, r;
  MatrixXd mass_matrix;
  VectorXd forcing, qdot, udot;
  std::optional<double> kinetic_energy, potential_energy, power_nonconservative;
  VectorXd configuration_residual, velocity_residual; // empty if there are no constraints
};

// x' = A x + B r about an operating point; x names the independent coordinates, followed by the speeds.
struct linearization {
  std::string label;
  VectorXd q, u, r, qdot, udot;
  std::vector<std::string> x;
  MatrixXd A, B;
  std::vector<std::complex<double>> eigenvalues;
};

// Names as in a model: q1, T, and theta'' for the second derivative of a prescribed theta.
struct system {
  std::vector<std::string> q, u, r, q_dependent, u_dependent;
  std::map<std::string, double> parameters;
  std::vector<state> states;
  std::vector<linearization> linearizations;
};

struct body {
  double mass = 0;
  Eigen::Vector3d com;
  Eigen::Matrix<double, 6, 1> inertia; // ixx, iyy, izz, ixy, iyz, izx about the mass center
};

// At `position` in its parent's frame, rotated by `rotation` (columns: the axes of the body in the parent's
// frame).
struct link : body {
  std::string name;
  int parent = -1; // -1: the ground, or the floating base
  char axis = 'z';
  Eigen::Matrix3d rotation;
  Eigen::Vector3d position;
};

struct robot_state {
  VectorXd q, u, a, torque; // in
  MatrixXd mass_matrix;
  VectorXd bias, udot, inverse_dynamics;
};

struct robot {
  Eigen::Vector3d gravity;
  std::optional<body> base;
  std::vector<link> links;
  std::vector<robot_state> states;
};

// M q'' + v C1 q' + (g K0 + v^2 K2) q = f; A and eigenvalues, keyed by the speed v in m/s.
struct bicycle {
  std::map<std::string, double> parameters;
  Eigen::Matrix2d M, C1, K0, K2;
  std::map<int, Eigen::Matrix4d> A;
  std::map<int, std::vector<std::complex<double>>> eigenvalues;
  double weave_speed = 0, capsize_speed = 0;
};

// By file name without the extension; a missing file, or one of a different kind, ends the test program.
system load(const std::string& name);
robot load_robot(const std::string& name);
bicycle load_bicycle(const std::string& name = "bicycle_canonical");
// Tables of numbers, by name.
std::map<std::string, MatrixXd> load_tables(const std::string& name);

// The largest difference relative to the largest element of b; infinite if the sizes differ or elements are
// not finite.
double relative_error(const Eigen::Ref<const MatrixXd>& a, const Eigen::Ref<const MatrixXd>& b);

// EXPECT_TRUE(oracle::close(mass_matrix, state.mass_matrix, 1e-12))
testing::AssertionResult close(const Eigen::Ref<const MatrixXd>& actual,
                               const Eigen::Ref<const MatrixXd>& expected, double tolerance);

} // namespace oracle
