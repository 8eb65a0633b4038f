// builds: g++
#include "systems/check_lagrange.hpp"

#include <models/n_pendulum_cart.hpp>

namespace {

TEST(lagrange, n_pendulum_cart) {
  using namespace n_pendulum_cart;
  const check::numbers values = oracle::load("npendulum_cart_n5").parameters;
  check::lagrange_against_kane<System<5>, LagrangeSystem<5>, true>(values, 3);
  check::lagrange_against_oracle<LagrangeSystem<5>>("npendulum_cart_n5");
}

} // namespace
