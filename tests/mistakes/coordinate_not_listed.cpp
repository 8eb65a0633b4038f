// expect: coordinate s, which the offset of point Q contains, is not in the list of coordinates
#include "pendulum.hpp"

struct Q : offset<Q, P, s * A::y> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
