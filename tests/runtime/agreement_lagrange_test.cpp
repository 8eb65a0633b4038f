// builds: g++
#include "models/arm3.hpp"
#include "models/double_pendulum.hpp"
#include "models/rotating_tube.hpp"
#include "runtime/agreement.hpp"

TEST(agreement_lagrange, double_pendulum) { agreement::check<double_pendulum::LagrangeSystem>(); }
TEST(agreement_lagrange, rotating_tube) { agreement::check<rotating_tube::LagrangeSystem>(); }
TEST(agreement_lagrange, arm3) { agreement::check<arm3::LagrangeSystem>(); }
