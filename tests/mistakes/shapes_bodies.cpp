// Points and bodies with too few, too many or wrong arguments.
#include "shapes.hpp"

// expect: point G lacks an argument; write offset<Self, From, vector>
namespace n1 {
struct G : offset<G, O> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n1

// expect: point G has too many arguments; write offset<Self, From, vector>
namespace n2 {
struct G : offset<G, O, l, A::x> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n2

// expect: the offset of point G is a scalar; it must be a vector
namespace n3 {
struct G : offset<G, O, l> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n3

// expect: point G lacks an argument; write origin<Self, Frame>
namespace n4 {
struct G : origin<G> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n4

// expect: point G has too many arguments; write origin<Self, Frame>
namespace n5 {
struct G : origin<G, N, A> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n5

// expect: point G lacks an argument; write velocity<Reference, vector>
namespace n6 {
struct G : offset<G, O, l * A::x>, velocity<N> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n6

// expect: point G has too many arguments; write velocity<Reference, vector>
namespace n7 {
struct G : offset<G, O, l * A::x>, velocity<N, u, A::y> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n7

// expect: N, which G uses as a point, is a frame
namespace n8 {
struct G : offset<G, N, l * A::x> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n8

// expect: body Ball lacks an argument; write particle<Self, Point, mass>
namespace n9 {
struct Ball : particle<Ball, P> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n9

// expect: body Ball has too many arguments; write particle<Self, Point, mass>
namespace n10 {
struct Ball : particle<Ball, P, m, l> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n10

// expect: A, which Ball uses as a point, is a frame
namespace n11 {
struct Ball : particle<Ball, A, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n11

// expect: body Rod lacks an argument; write rigid_body<Self, Center, Frame, mass, Inertia>
namespace n12 {
struct Rod : rigid_body<Rod, P, A, m> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n12

// expect: body Rod has too many arguments; write rigid_body<Self, Center, Frame, mass, Inertia>
namespace n13 {
struct Rod : rigid_body<Rod, P, A, m, inertia<A, m, m, m>, inertia<A, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n13

// expect: body Rod lacks an argument; write inertia<Frame, Ixx, Iyy, Izz, Ixy, Iyz, Izx>
namespace n14 {
struct Rod : rigid_body<Rod, P, A, m, inertia<A, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n14

// expect: body Rod has too many arguments; write inertia<Frame, Ixx, Iyy, Izz, Ixy, Iyz, Izx>
namespace n15 {
struct Rod : rigid_body<Rod, P, A, m, inertia<A, m, m, m, 0, 0, 0, 0>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n15

// expect: body Rod has too many arguments; write inertia_dyadic<dyadic>
namespace n16 {
struct Rod : rigid_body<Rod, P, A, m, inertia_dyadic<m, outer(A::x, A::x)>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n16

// expect: body Rod lacks an argument; write inertia_about<Point, Inertia>
namespace n17 {
struct Rod : rigid_body<Rod, P, A, m, inertia_about<O>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n17

// expect: the inertia of Rod is O, which is not an inertia
namespace n18 {
struct Rod : rigid_body<Rod, P, A, m, O> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n18

// expect: the inertia of Disc is A, which is not an inertia
namespace n19 {
struct Disc : rigid_body<Disc, P, A, m, inertia_about<O, A>> {};
struct System : pendulum_with<Disc> {};
void f() { use<System>(); }
} // namespace n19

// expect: A, which Wheel uses as a point, is a frame
namespace n20 {
struct Wheel : rigid_body<Wheel, A, P, m, inertia<A, m, m, m>> {};
struct System : pendulum_with<Wheel> {};
void f() { use<System>(); }
} // namespace n20
