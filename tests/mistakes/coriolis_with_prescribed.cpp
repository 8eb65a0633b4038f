// expect: the Coriolis matrix requires a mass matrix that depends only on coordinates; this one depends on
// expect: the prescribed quantity d
#include "pendulum.hpp"

constexpr prescribed<"d"> d;

struct Rope : offset<Rope, O, d * A::x> {};
struct Load : particle<Load, Rope, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Load>> {};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(eom::state(), eom::parameters(), eom::inputs()); }
