// A rattleback that is spun in the wrong direction: it begins to rattle, and reverses its spin.
#include <models/rattleback.hpp>

#include <cstdio>

using eom = kanexpr::equations_of_motion<rattleback::System>;

// One step of the classic Runge-Kutta method.
eom::state after(const eom::state& x, const eom::parameters& p, double step) {
  const auto rate = [&](const eom::state& at) { return eom::state(eom::rhs(at, p)); };
  const eom::state k1 = rate(x);
  const eom::state k2 = rate(eom::state(x + step / 2 * k1));
  const eom::state k3 = rate(eom::state(x + step / 2 * k2));
  const eom::state k4 = rate(eom::state(x + step * k3));
  return eom::state(x + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
}

int main() {
  using namespace rattleback;

  eom::parameters p;
  p[a] = 0.2;
  p[b] = 0.03;
  p[c] = 0.02;
  p[h] = 0.01;
  p[m] = 1.0;
  p[Ixx] = 0.0002;
  p[Iyy] = 0.0016;
  p[Izz] = 0.0017;
  p[Ixy] = -0.00002;
  p[g] = 9.81;
  p[sigma] = 0; // no friction, so the energy is conserved

  eom::state x;
  x[q2] = 0.0087;
  x[q3] = 0.0087;
  x[u3] = -5;

  const auto energy = [&] { return eom::kinetic_energy(x, p) + eom::potential_energy(x, p); };
  for (int second = 0; second <= 5; ++second) {
    std::printf("after %d s: spin %6.3f rad/s, energy %.9f J\n", second, x[u3], energy());
    for (int i = 0; i < 10000; ++i) x = after(x, p, 0.0001);
  }
}
