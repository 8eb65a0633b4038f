// A four-bar linkage with numbers, close to an assembled position.
#pragma once

#include "models/four_bar.hpp"

struct four_bars {
  using System = four_bar::System;
  using eom = kanexpr::equations_of_motion<System>;
  eom::parameters p = eom::parameters::Constant(0.5);
  eom::inputs r = eom::inputs::Constant(0.3);
  eom::state x = eom::state::Zero();
  four_bars() {
    using namespace four_bar;
    p[l0] = 2, p[l1] = 0.7, p[l2] = 1.8, p[l3] = 1.2;
    x[q1] = 0.6, x[q2] = 0.3, x[q3] = -1.7;
    x[u1] = 1.4;
  }
};
