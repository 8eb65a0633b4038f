#include "pendulum.hpp"

#include <kanexpr/simulate.hpp>

int main() {
  using namespace pendulum;
  const auto run = kanexpr::simulate<System>({{q, 0.1}, {u, 0}}, {{l, 1}}, {0, 1});
  return run && run.time == 1 ? 0 : 1;
}
