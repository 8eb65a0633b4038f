#include "models/iiwa.hpp"
#include "demo/compiled.hpp"
#include "demo/time_of.hpp"

demo::compiled demo::compiled_iiwa() {
  using eom = kanexpr::equations_of_motion<iiwa::System>;
  eom::state x;
  eom::inputs torques;
  Eigen::Matrix<double, 7, 1> reference;
  x << 1.5983500054156474, 2.8230427165131764, -2.403856968140654, 2.462463113609908, -2.253957243345467,
      -2.795432129551702, 2.089303505574744, 1.6028419058388335, 1.0229801389603872, -0.7658851334901042,
      1.9810473071146575, -0.9295545463277721, -1.827115098690923, -1.3251036898270434;
  torques << 4.3581136929800675, -2.0510909116853213, -3.9198967114836556, 7.330850218702025,
      -4.1536102078199875, -7.5263821324586715, -3.3813444387841574;
  reference << 6.772213739024573, 6.049036213371251, -36.87733612753212, -1.837199245099049,
      -824.8790924669422, -860.4540008063422, -4120.95347335856;
  return {eom::udot(x, eom::parameters(), torques),
          reference,
          {{"mass matrix and forcing", eom::cost(eom::together(eom::mass_matrix, eom::forcing))},
           {"u'", eom::cost(eom::udot)}},
          time_of(x, [&](const eom::state& at) { return eom::udot(at, eom::parameters(), torques); })};
}
