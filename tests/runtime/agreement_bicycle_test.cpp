// builds: g++
#include "models/bicycle.hpp"
#include "runtime/agreement.hpp"

TEST(agreement, bicycle) { agreement::check_rhs<bicycle::System>(); }
