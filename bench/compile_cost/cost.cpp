// What one call of each function of each model costs: the operations of the code that the compiler is given.
#include <models/arm3.hpp>
#include <models/double_pendulum.hpp>
#include <models/iiwa.hpp>
#include <models/n_pendulum_cart.hpp>
#include <models/pendulum6.hpp>
#include <models/puma.hpp>
#include <models/quadruped.hpp>
#include <models/rolling_disc.hpp>
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

} // namespace

int main() {
  std::puts("system\tfunction\tmul\tadd\tdiv\ttrig\tnodes");
  lines<simple_pendulum::System>("simple_pendulum");
  lines<double_pendulum::System>("double_pendulum");
  lines<n_pendulum_cart::System<5>>("n_pendulum_cart");
  lines<spinning_top::System>("spinning_top");
  lines<rolling_disc::System>("rolling_disc");
  lines<arm3::System>("arm3");
  lines<pendulum6::System>("pendulum6");
  lines<puma::System>("puma");
  lines<iiwa::System>("iiwa");
  lines<quadruped::System>("quadruped");
}
