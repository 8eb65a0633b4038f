// builds: g++
#include "models/n_pendulum_cart.hpp"
#include "models/pendulum6.hpp"
#include "models/puma.hpp"
#include "runtime/agreement.hpp"

TEST(agreement, n_pendulum_cart) { agreement::check<n_pendulum_cart::System<5>>(); }
TEST(agreement, pendulum6) { agreement::check<pendulum6::System>(); }
TEST(agreement, puma) { agreement::check<puma::System>(); }
