// builds: g++
#include "models/iiwa.hpp"
#include "runtime/agreement.hpp"

TEST(agreement, iiwa) { agreement::check<iiwa::System>(); }
