// expect: the Coriolis matrix is that of a mass matrix which changes with the coordinates alone; this one
// changes expect: with the prescribed quantity d
#include "pendulum.hpp"

constexpr prescribed<"d"> d;

struct Rope : offset<Rope, O, d * A::x> {};
struct Load : particle<Load, Rope, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Load>> {};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(eom::state(), eom::parameters(), eom::inputs()); }
