// expect: the offset of point Q holds a velocity or derivative, which is not known yet while a model is read
#include "pendulum.hpp"

struct Q : offset<Q, O, velocity_of<P>> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
