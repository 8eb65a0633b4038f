// A gymnast with one motor, at the hips, balances on a bar.
#include <kanexpr/control.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/numeric/as_eigen.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <parts/page.hpp>
#include <pictures/double_pendulum.hpp>

namespace acrobot {

using namespace double_pendulum;

constexpr double period = 0.005, top = std::numbers::pi / 2; // s, rad
constexpr auto numbers = constant_parameters<System>({{m1, 1},
                                                      {m2, 1},
                                                      {d1, 0.5},
                                                      {d2, 0.5},
                                                      {l1, 1},
                                                      {I1, 1 / 12.0},
                                                      {I2, 1 / 12.0},
                                                      {g, 9.81},
                                                      {c1, 0},
                                                      {c2, 0}});
constexpr auto both = linearization<System>::explicit_form.constant(
    constant_state<System>({{q1, top}, {q2, 0}, {u1, 0}, {u2, 0}}), numbers,
    constant_inputs<System>({{T1, 0}, {T2, 0}}));
constexpr auto linear =
    discretize(std::get<0>(both), std::get<1>(both).at({0, 1, 2, 3}, {1}), period); // only T2
constexpr auto regulator = dlqr(linear.A, linear.B, {10, 10, 1, 1}, {1});
static_assert(regulator);

} // namespace acrobot

int main(int count, char** words) {
  using namespace acrobot;
  gallery::page page(
      count, words,
      {.title = "Acrobot",
       .kind = "Control",
       .see = "Only the joint between the two bars has a motor; the shoulder turns freely. The upper bar "
              "first swings away and "
              "pushes the lower one back under it, as a gymnast does on a beam.",
       .source = "Spong, The swing up control problem for the Acrobot, IEEE Control Systems 15 (1995), pages "
                 "49-55; "
                 "Murray & Hauser, A case study in approximate linearization: the Acrobot example (1991)"});
  const parameter_values<System> p(1, 1, 0.5, 0.5, 1, 1 / 12.0, 1 / 12.0, 9.81, 0, 0);
  state<System> x{{q1, top + 0.1}, {q2, -0.3}, {u1, 0}, {u2, 0}};
  const state<System> standing{{q1, top}, {q2, 0}, {u1, 0}, {u2, 0}};
  trajectory<System> path(p);
  double t = 0;
  for (int k = 0; k < 6 / period; ++k) {
    const double torque = -(numeric::as_eigen(regulator.K) * (x - standing)).value();
    const input_values<System> acting{{T1, 0}, {T2, torque}};
    if (k % 4 == 0) path.add({t, x, acting});
    if (const status s = runge_kutta_4<System>{}(t, x, period, p, acting); !s) page.refuse(s.cause());
  }
  std::printf("ends at %g %g\n", x[q1] - top, x[q2]);
  page.expect((x - standing).cwiseAbs().maxCoeff() < 0.01, "both bars stand at the end");
  return page.show<double_pendulum::picture>(path, {.at = 0.3});
}
