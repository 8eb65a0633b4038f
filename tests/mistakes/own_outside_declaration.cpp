// expect: the offset of point Q holds own::x, which stands for a frame while its angular velocity is
// expect: declared; write N::x
#include "pendulum.hpp"

struct Q : offset<Q, O, l * own::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
