// builds: g++
#include "models/quadruped.hpp"
#include "runtime/agreement.hpp"

TEST(agreement, quadruped) { agreement::check_rhs<quadruped::System>(); }
