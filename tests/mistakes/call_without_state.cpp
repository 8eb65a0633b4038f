// expect: a result requires a state; call it as f(t, x, p, r)
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() { eom::mass_matrix(0.0, {}, eom::parameters()); }
