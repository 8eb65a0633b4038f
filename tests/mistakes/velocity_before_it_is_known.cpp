// expect: the offset of point Q contains a velocity or derivative, which is not yet known while the model is
// expect: read
#include "pendulum.hpp"

struct Q : offset<Q, O, velocity_of<P>> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
