// expect: the offset of point G is given along the axes of B and depends on the omitted angle of B
#include "pendulum.hpp"

struct B : rotated<B, N, 0, N::z>, angular_velocity<N, u * N::z> {};
struct G : offset<G, O, l * B::x> {};
struct Ball : particle<Ball, G, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
