// expect: udot is evaluated with the scalar type complex<double>, which lift does not accept
#include "pendulum.hpp"

#include <complex>

struct lift_force {
  double operator()(double speed, double angle) const { return speed * angle; }
};
constexpr external<"lift", lift_force> lift;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, lift(u, q) * N::x>>> {};
using eom = equations_of_motion<System>;

int main() {
  const state<System, std::complex<double>> x = eom::state().cast<std::complex<double>>();
  return eom::udot(x, eom::parameters())(0).real() > 0;
}
