// What one call of each function of each model costs: the operations of the code that the compiler is given.
#include <models/andrews.hpp>
#include <models/arm3.hpp>
#include <models/bicycle.hpp>
#include <models/chaplygin_sleigh.hpp>
#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/n_pendulum_cart.hpp>
#include <models/pendulum6.hpp>
#include <models/pendulum_nonminimal.hpp>
#include <models/pivot_body.hpp>
#include <models/puma.hpp>
#include <models/quadruped.hpp>
#include <models/rattleback.hpp>
#include <models/rocket.hpp>
#include <models/rolling_disc.hpp>
#include <models/rolling_disc_constrained.hpp>
#include <models/rolling_torus.hpp>
#include <models/rotating_tube.hpp>
#include <models/simple_pendulum.hpp>
#include <models/spinning_top.hpp>

#include <kanexpr/derivation/cost.hpp>

#include <cstdio>

namespace {

using kanexpr::mechanics::quantity;

template <class System>
void line(const char* system, const char* function, std::initializer_list<quantity> wanted) {
  const kanexpr::symbolic::cost c = kanexpr::derivation::cost_of<System>(wanted);
  std::printf("%s\t%s\t%d\t%d\t%d\t%d\t%d\n", system, function, c.multiplications, c.additions, c.divisions,
              c.trigonometric, c.nodes);
}

template <class System>
void lines(const char* system) {
  line<System>(system, "mass_matrix", {quantity::mass_matrix});
  line<System>(system, "forcing", {quantity::forcing});
  line<System>(system, "mass_matrix+forcing", {quantity::mass_matrix, quantity::forcing});
  line<System>(system, "udot", {quantity::udot});
}

template <class System>
void constrained_lines(const char* system) {
  lines<System>(system);
  line<System>(system, "mass_matrix+forcing+acceleration_bias",
               {quantity::mass_matrix, quantity::forcing, quantity::acceleration_bias});
}

template <class System>
void linearization_line(const char* system) {
  line<System>(system, "linearization", {quantity::state_matrix, quantity::input_matrix});
  line<System>(
      system, "linearization M, A, B",
      {quantity::implicit_mass_matrix, quantity::implicit_state_matrix, quantity::implicit_input_matrix});
}

template <class System>
void second_order_lines(const char* system) {
  line<System>(system, "jacobian", {quantity::state_jacobian, quantity::input_jacobian});
  line<System>(system, "gradient", {quantity::weighted_gradient});
  line<System>(system, "hessian", {quantity::weighted_hessian});
  line<System>(system, "hessian_product", {quantity::weighted_hessian_product});
}

template <class System>
void regressor_line(const char* system) {
  line<System>(system, "regressor", {quantity::regressor});
}

} // namespace

int main() {
  std::puts("system\tfunction\tmul\tadd\tdiv\tsincos\tnodes");
  lines<simple_pendulum::System>("simple_pendulum");
  lines<double_pendulum::System>("double_pendulum");
  lines<n_pendulum_cart::System<5>>("n_pendulum_cart");
  lines<spinning_top::System>("spinning_top");
  lines<pivot_body::System>("pivot_body");
  lines<rocket::System>("rocket");
  lines<rotating_tube::System>("rotating_tube");
  lines<rolling_disc::System>("rolling_disc");
  lines<rolling_torus::System>("rolling_torus");
  lines<rattleback::System>("rattleback");
  constrained_lines<rolling_disc_constrained::System>("rolling_disc_constrained");
  constrained_lines<chaplygin_sleigh::System>("chaplygin_sleigh");
  constrained_lines<pendulum_nonminimal::System>("pendulum_nonminimal");
  constrained_lines<four_bar::System>("four_bar");
  constrained_lines<andrews::System>("andrews");
  constrained_lines<bicycle::System>("bicycle");
  constrained_lines<bicycle::BoundSystem>("bicycle_bound");
  lines<arm3::System>("arm3");
  lines<pendulum6::System>("pendulum6");
  lines<puma::System>("puma");
  lines<iiwa::System>("iiwa");
  lines<quadruped::System>("quadruped");
  linearization_line<simple_pendulum::System>("simple_pendulum");
  linearization_line<four_bar::System>("four_bar");
  linearization_line<bicycle::System>("bicycle");
  linearization_line<bicycle::BoundSystem>("bicycle_bound");
  linearization_line<puma::System>("puma");
  linearization_line<iiwa::System>("iiwa");
  second_order_lines<double_pendulum::System>("double_pendulum");
  second_order_lines<bicycle::System>("bicycle");
  second_order_lines<iiwa::System>("iiwa");
  second_order_lines<quadruped::System>("quadruped");
  regressor_line<double_pendulum::System>("double_pendulum");
  regressor_line<iiwa::System>("iiwa");
}
