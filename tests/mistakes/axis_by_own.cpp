// expect: the axis of frame C holds own::z, which stands for a frame while its angular velocity is declared;
// expect: write A::z
#include "pendulum.hpp"

struct C : rotated<C, A, q, own::z> {};
struct End : offset<End, P, l * C::x> {};
struct Weight : particle<Weight, End, m> {};
struct System : pendulum_with<Weight> {};

int main() { use<System>(); }
