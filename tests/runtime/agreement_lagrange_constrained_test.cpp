// builds: g++
#include "models/chaplygin_sleigh.hpp"
#include "models/four_bar.hpp"
#include "models/pendulum_nonminimal.hpp"
#include "models/rolling_disc_constrained.hpp"
#include "runtime/agreement.hpp"

TEST(agreement_lagrange, pendulum_nonminimal) { agreement::check<pendulum_nonminimal::LagrangeSystem>(); }
TEST(agreement_lagrange, chaplygin_sleigh) { agreement::check_rhs<chaplygin_sleigh::LagrangeSystem>(); }
TEST(agreement_lagrange, four_bar) { agreement::check_rhs<four_bar::LagrangeSystem>(); }
TEST(agreement_lagrange, rolling_disc) { agreement::check_rhs<rolling_disc_constrained::LagrangeSystem>(); }
