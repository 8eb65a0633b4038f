// expect: the axis of frame C contains own::z, which is valid only in the declared angular velocity of a
// expect: frame; write A::z
#include "pendulum.hpp"

struct C : rotated<C, A, q, own::z> {};
struct End : offset<End, P, l * C::x> {};
struct Weight : particle<Weight, End, m> {};
struct System : pendulum_with<Weight> {};

int main() { use<System>(); }
