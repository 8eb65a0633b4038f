// expect: point Q names itself P; the first template argument of its base must be Q
#include "pendulum.hpp"

struct Q : offset<P, O, l * A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
