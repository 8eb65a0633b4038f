// Words of the library as base classes of entities to which they do not belong.
#include "shapes.hpp"

// expect: a load is a separate base class of System; list it in the system's loads<...>
namespace n1 {
struct System : pendulum_with<Bob>, gravity<-g * N::y> {};
void f() { use<System>(); }
} // namespace n1

// expect: a load is a separate base class of Swing; list it in the system's loads<...>
namespace n2 {
struct Swing : pendulum_with<Bob>, spring<P, Q, k>, damper<P, Q, c> {};
void f() { use<Swing>(); }
} // namespace n2

// expect: a load is a base class of Bead; list it in the system's loads<...>
namespace n3 {
struct Bead : particle<Bead, P, m>, gravity<-g * N::y> {};
struct System : pendulum_with<Bead> {};
void f() { use<System>(); }
} // namespace n3

// expect: a load is a base class of Tip; list it in the system's loads<...>
namespace n4 {
struct Tip : offset<Tip, P, l * A::x>, force<Tip, F * N::y> {};
struct System : loaded<force<Tip, F * N::x>> {};
void f() { use<System>(); }
} // namespace n4

// expect: a load is a base class of B; list it in the system's loads<...>
namespace n5 {
struct B : rotated<B, N, q, N::z>, torsional_spring<q, k> {};
struct System : loaded<torque<B, T * N::z>> {};
void f() { use<System>(); }
} // namespace n5

// expect: a word of the system is a base class of B; list it among the words of the system
namespace n6 {
struct B : rotated<B, N, q, N::z>, values<m == 2> {};
struct System : loaded<torque<B, T * N::z>> {};
void f() { use<System>(); }
} // namespace n6

// expect: a word of the system is a base class of Bead; list it among the words of the system
namespace n7 {
struct Bead : particle<Bead, P, m>, velocity_constraints<u == 0> {};
struct System : pendulum_with<Bead> {};
void f() { use<System>(); }
} // namespace n7

// expect: B is described both as a frame and as a point; give each its own name
namespace n8 {
struct B : rotated<B, N, q, N::z>, offset<B, O, l * A::x> {};
struct System : loaded<force<B, F * N::x>> {};
void f() { use<System>(); }
} // namespace n8

// expect: B is described both as a frame and as a body; give each its own name
namespace n9 {
struct B : rotated<B, N, q, N::z>, rigid_body<B, P, A, m, inertia<A, m, m, m>> {};
struct System : pendulum_with<B> {};
void f() { use<System>(); }
} // namespace n9

// expect: Bead is described both as a point and as a body; give each its own name
namespace n10 {
struct Bead : offset<Bead, O, l * A::x>, particle<Bead, P, m> {};
struct System : pendulum_with<Bead> {};
void f() { use<System>(); }
} // namespace n10

// expect: Start is described both as a point and as a body; give each its own name
namespace n11 {
struct Start : particle<Start, P, m>, origin<Start, N> {};
struct Tip : offset<Tip, Start, l * A::x> {};
struct System : loaded<force<Tip, F * N::x>> {};
void f() { use<System>(); }
} // namespace n11

// expect: Weight is declared as two loads; give each its own name
namespace n12 {
struct Weight : force<P, F * N::x>, gravity<-g * N::y> {};
struct System : loaded<Weight> {};
void f() { use<System>(); }
} // namespace n12

// expect: a load is a base class of Weight; list it in the system's loads<...>
namespace n13 {
struct Weight : gravity<-g * N::y>, particle<Weight, P, m> {};
struct System : loaded<Weight> {};
void f() { use<System>(); }
} // namespace n13

// expect: angular_velocity<...> is a base class of Weight, which is not a frame
namespace n14 {
struct Weight : gravity<-g * N::y>, angular_velocity<N, u * N::z> {};
struct System : loaded<Weight> {};
void f() { use<System>(); }
} // namespace n14

// expect: a load is a separate base class of Loads; list it in the system's loads<...>
namespace n15 {
struct Loads : loads<weight>, gravity<-g * N::y> {};
struct System : told<Loads> {};
void f() { use<System>(); }
} // namespace n15

// expect: System is described both as a system and as part of a system; give each its own name
namespace n16 {
struct System : pendulum_with<Bob>, offset<System, O, l * A::x> {};
void f() { use<System>(); }
} // namespace n16

// expect: System is derived from two systems; define a separate struct for each
namespace n17 {
struct System : pendulum_with<Bob>, rates_of_pendulum<bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n17

// expect: Tip is described both as part of a system and as a whole system; give each its own name
namespace n18 {
struct Tip : offset<Tip, P, l * A::x>, pendulum_with<Bob> {};
struct System : loaded<force<Tip, F * N::x>> {};
void f() { use<System>(); }
} // namespace n18

// Private bases.

// expect: System inherits privately; declare it as a struct
namespace n19 {
class System : pendulum_with<Bob> {};
void f() { use<System>(); }
} // namespace n19

// expect: Bead inherits privately; declare it as a struct
namespace n20 {
class Bead : particle<Bead, P, m> {};
struct System : pendulum_with<Bead> {};
void f() { use<System>(); }
} // namespace n20

// expect: Tip inherits privately; declare it as a struct
namespace n21 {
class Tip : offset<Tip, P, l * A::x> {};
struct System : loaded<force<Tip, F * N::x>> {};
void f() { use<System>(); }
} // namespace n21

// expect: a frame other than A names itself A; the first template argument of a frame's base must be the
// expect: frame itself
namespace n22 {
struct B : rotated<A, N, s, N::z> {};
struct Tip : offset<Tip, O, l * B::x> {};
struct System : loaded<force<Tip, F * N::x>> {};
void f() { use<System>(); }
} // namespace n22

// expect: a frame other than A names itself A; the first template argument of a frame's base must be the
// expect: frame itself
namespace n23 {
struct B : quaternion<A, N, 1, 0, 0, 0> {};
struct System : loaded<torque<A, T * B::z>> {};
void f() { use<System>(); }
} // namespace n23
