// Forces that act twice, and weights for accelerations.
#include "shapes.hpp"

// expect: gravity holds m, the mass of Bob; it is the acceleration of free fall, not a weight
namespace n1 {
struct System : loaded<gravity<-m * g * N::y>> {};
void f() { use<System>(); }
} // namespace n1

// expect: the force at P is the weight of Bob, which gravity gives it already
namespace n2 {
struct System : loaded<gravity<-g * N::y>, force<P, -m * g * N::y>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the force at P is listed twice
namespace n3 {
struct System : loaded<force<P, -m * u * N::y>, force<O, u * N::x>, force<P, -u * m * N::y>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the torque on A is listed twice
namespace n4 {
struct System : loaded<torque<A, u * N::z>, torque<A, u * N::z>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the force between P and O is listed twice
namespace n5 {
struct System : loaded<force_between<P, O, u * N::x>, force_between<P, O, u * N::x>> {};
void f() { use<System>(); }
} // namespace n5
