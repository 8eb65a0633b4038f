// expect: the constraints cannot be solved for the dependent rates of coordinates q and s in any
// expect: configuration
#include "pendulum.hpp"

constexpr coordinate<"y"> y;
struct Y : offset<Y, O, y * N::y> {};
struct Ball : particle<Ball, Y, m> {};

struct System : lagrange_system<inertial<N>, coordinates<q, s, y>, bodies<Bob, Block, Ball>,
                                velocity_constraints<dot(q) + dot(s) == 0, dot(q) + dot(s) + 2 * dot(y) == 0>,
                                dependent<dot(q), dot(s)>> {};

int main() { use_rates<System>(); }
