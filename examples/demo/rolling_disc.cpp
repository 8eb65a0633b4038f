#include "models/rolling_disc.hpp"
#include "demo/compiled.hpp"
#include "demo/time_of.hpp"

demo::compiled demo::compiled_rolling_disc() {
  using eom = kanexpr::equations_of_motion<rolling_disc::System>;
  eom::state x;
  eom::parameters p;
  x << -2.193815, 0.833841, 1.582648, -1.959448, -0.036519, -0.404071;
  p[rolling_disc::r] = 0.45;
  p[rolling_disc::m] = 2.2;
  p[rolling_disc::g] = 9.81;
  return {eom::udot(x, p),
          Eigen::Vector3d(12.896361274376956, -0.5278374085386667, 0.7293233304981176),
          {{"mass matrix and forcing", eom::cost(eom::together(eom::mass_matrix, eom::forcing))},
           {"u'", eom::cost(eom::udot)}},
          time_of(x, [&](const eom::state& at) { return eom::udot(at, p); })};
}
