// builds: clang++ sanitize
#include "models/arm3.hpp"
#include "models/double_pendulum.hpp"
#include "models/rolling_disc.hpp"
#include "models/simple_pendulum.hpp"
#include "models/spinning_top.hpp"
#include "runtime/agreement.hpp"

TEST(agreement, simple_pendulum) { agreement::check<simple_pendulum::System>(); }
TEST(agreement, double_pendulum) { agreement::check<double_pendulum::System>(); }
TEST(agreement, spinning_top) { agreement::check<spinning_top::System>(); }
TEST(agreement, rolling_disc) { agreement::check<rolling_disc::System>(); }
TEST(agreement, arm3) { agreement::check<arm3::System>(); }
