// expect: the Coriolis matrix requires the coordinate rates as speeds; the rate of x is not a speed
#include "pendulum.hpp"

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;

struct Skate : offset<Skate, O, x * N::x + y * N::y> {};
struct G : offset<G, Skate, l * A::x> {};
struct Body : rigid_body<Body, G, A, m, inertia<A, 0, 0, 0.3>> {};
struct System : kane_system<inertial<N>, coordinates<q, s, x, y>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(s) == v, dot(x) == v * cos(q), dot(y) == v * sin(q)>,
                            bodies<Body>> {};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(eom::state(), eom::parameters()); }
