// expect: coordinates q and s move the same mass in any configuration: the mass matrix is numerically
// expect: singular
#include "pendulum.hpp"

struct B : rotated<B, A, s, A::z> {}; // two rotations about the same axis are one angle
struct End : offset<End, O, l * B::x> {};
struct Ball : particle<Ball, End, m> {};

struct System : rates_of_both<bodies<Ball>> {};

int main() { use_rates<System>(); }
