// A cart balances a pendulum: the equations are linearized about the upright equilibrium, a state feedback is
// designed by pole placement, and the nonlinear system moves under its control.
#include "output.hpp"
#include "print.hpp"

#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>
#include <pictures/n_pendulum_cart.hpp>

#include <Eigen/LU>

#include <cstdio>

namespace {

using namespace n_pendulum_cart;
using balanced = System<1>;
using lin = linearization<balanced>;

constexpr Eigen::Index order = lin::states;
using square = Eigen::Matrix<double, order, order>;
using column = Eigen::Vector<double, order>;
using row = Eigen::RowVector<double, order>;

// K in r = −K x such that A − B K has these poles: Ackermann's formula.
row feedback(const square& A, const column& B, const column& poles) {
  square controllability, polynomial = square::Identity();
  column next = B;
  for (Eigen::Index i = 0; i < order; ++i) {
    controllability.col(i) = next;
    next = A * next;
    polynomial = polynomial * (A - poles(i) * square::Identity());
  }
  return controllability.inverse().row(order - 1) * polynomial;
}

} // namespace

int main(int count, char** words) {
  const output files("A balanced pendulum", "The cart pushes so that the pendulum stays up.", count, words);
  const kanexpr::operating_point<balanced> upright(
      {{q<1>, 1.4}}, {{m<0>, 1.5}, {m<1>, 0.4}, {l<0>, 0.8}, {g, 9.81}}, {.held = {q<0>}});
  if (!upright) return std::fprintf(stderr, "%s\n", upright.cause().c_str()), 1;
  const auto [A, B] = lin::explicit_form(upright.x, upright.p, upright.r);
  const column poles{-5, -4, -3, -2};
  const row K = feedback(A, B, poles);

  state<balanced> start = upright.x;
  start[q<0>] = -1;
  start[q<1>] += 0.4;
  const auto run =
      simulate<balanced>(start, upright.p, {0, 8},
                         {.inputs = [&](double, const state<balanced>& x,
                                        input_values<balanced>& r) { r = upright.r - K * (x - upright.x); },
                          .output_every = 0.01});
  if (!run) return std::fprintf(stderr, "%s\n", run.cause().c_str()), 1;

  print("angle of the equilibrium", upright.x[q<1>]);
  print("feedback", K);
  for (const double t : {0.0, 1.0, 2.0, 4.0, 8.0})
    std::printf("after %g s: cart at %9.6f m, pendulum %9.6f rad off\n", t, run.trajectory.at(t)->x[q<0>],
                run.trajectory.at(t)->x[q<1>] - upright.x[q<1>]);
  return files.leave<n_pendulum_cart::picture>(run.trajectory) ? 0 : 1;
}
