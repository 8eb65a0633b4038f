// Linearizations, compared with reference results and with complex steps through the nonlinear equations, in
// which the dependent coordinates and speeds follow a step by Newton's method.
#pragma once

#include "oracles.hpp"

#include <kanexpr/symbolic.hpp>

#include <complex>

namespace check {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::mechanics::quantity;
using complex = std::complex<double>;

// The functions of a system derived at run time.
struct derived_functions {
  using real_function = kanexpr::runtime::interpreted<double>;
  using complex_function = kanexpr::runtime::interpreted<complex>;

  std::vector<std::string> q, u, r, p;
  std::vector<Eigen::Index> states, dependent_coordinates, dependent_speeds; // places in [q; u]
  real_function A, B;
  complex_function gap, gap_jacobian, speeds, rhs;

  explicit derived_functions(kanexpr::mechanics::equations& e);

private:
  template <class Scalar>
  static kanexpr::runtime::interpreted<Scalar> function(kanexpr::mechanics::equations& e, quantity wanted);
  void read_names(const kanexpr::mechanics::mechanism& m);
  void read_places(const kanexpr::mechanics::equations& e);
};

struct explicit_form {
  MatrixXd A, B;
};

class linearized {
public:
  explicit linearized(derived_functions functions) : f_(std::move(functions)) {}

  const derived_functions& functions() const { return f_; }

  explicit_form at(double t, const VectorXd& x, const VectorXd& p, const VectorXd& r);
  explicit_form by_complex_steps(double t, const VectorXd& x, const VectorXd& p, const VectorXd& r);

  // Sets the dependent coordinates and speeds of a state such that the constraints hold, if there are such
  // values nearby.
  bool assemble(double t, VectorXd& x, const VectorXd& p, const VectorXd& r);

  // Parameters in the order of the system; bound ones are not in any vector.
  VectorXd parameters(const std::map<std::string, double>& values) const;

  void against_oracle(const std::string& name);
  // At 1000 random operating points that satisfy the constraints, with rates up to 2 and coordinates that
  // differ from `around` by up to `reach`; the parameters differ from those of an oracle by up to a fifth.
  void against_complex_steps(const std::string& name, const VectorXd& around, double reach);

private:
  VectorXd rates(double t, Eigen::VectorXcd x, const VectorXd& p, const Eigen::VectorXcd& r);
  void satisfy(double t, Eigen::VectorXcd& x, const VectorXd& p, const Eigen::VectorXcd& r, int rounds);

  derived_functions f_;
};

template <class System>
linearized linearize() {
  auto model = kanexpr::derive<System>();
  EXPECT_EQ(model.mistake(), "");
  return linearized(derived_functions(model.equations()));
}

// Runs both of the above.
template <class System>
void linearization_agrees(const std::string& oracle, const VectorXd& around, double reach) {
  linearized system = linearize<System>();
  system.against_oracle(oracle);
  system.against_complex_steps(oracle, around, reach);
}

} // namespace check
