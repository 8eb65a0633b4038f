// Frames with too few, too many or wrong arguments.
#include "shapes.hpp"

// expect: frame B lacks an argument; write rotated<Self, Parent, angle, axis>
namespace n1 {
struct B : rotated<B, N, q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n1

// expect: frame B1 lacks an argument; write rotated<Self, Parent, angle, axis>
namespace n2 {
struct B1 : rotated<B1, N> {};
struct Rod : rigid_body<Rod, P, B1, m, inertia<B1, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n2

// expect: frame B has too many arguments; write rotated<Self, Parent, angle, axis>
namespace n3 {
struct B : rotated<B, N, q, N::z, 1> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n3

// expect: the angle of frame B is a vector; it must be a scalar
namespace n4 {
struct B : rotated<B, N, N::z, q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n4

// expect: frame B lacks an argument; write body_fixed<Self, Parent, sequence, angle, angle, angle>
namespace n5 {
struct B : body_fixed<B, N, "zx", q, q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n5

// expect: frame B has too many arguments; write body_fixed<Self, Parent, sequence, angle, angle, angle>
namespace n6 {
struct B : body_fixed<B, N, "zxz", q, q, q, q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n6

// expect: frame B lacks an argument; write space_fixed<Self, Parent, sequence, angle, angle, angle>
namespace n7 {
struct B : space_fixed<B, N, "zxz", q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n7

// expect: frame B has an invalid rotation sequence; use three axes, no two consecutive ones equal: zxz
namespace n8 {
struct B : body_fixed<B, N, 313, q, q, q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n8

// expect: frame B2 has an invalid rotation sequence; use three axes, no two consecutive ones equal: zxz
namespace n9 {
struct B2 : body_fixed<B2, N, q, q, q, q> {};
struct Rod : rigid_body<Rod, P, B2, m, inertia<B2, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n9

// expect: frame B lacks an argument; write quaternion<Self, Parent, e0, e1, e2, e3>
namespace n10 {
struct B : quaternion<B, N, q, q, q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n10

// expect: frame B has too many arguments; write quaternion<Self, Parent, e0, e1, e2, e3>
namespace n11 {
struct B : quaternion<B, N, q, q, q, q, q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n11

// expect: frame B lacks an argument; write direction_cosines<Self, Parent, nine cosines row by row>
namespace n12 {
struct B : direction_cosines<B, N, 1, 0, 0, 0, 1, 0> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n12

// expect: frame B has too many arguments; write direction_cosines<Self, Parent, nine cosines row by row>
namespace n13 {
struct B : direction_cosines<B, N, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n13

// expect: frame B lacks an argument; write angular_velocity<Reference, vector>
namespace n14 {
struct B : rotated<B, N, q, N::z>, angular_velocity<N> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n14

// expect: frame B has too many arguments; write angular_velocity<Reference, vector>
namespace n15 {
struct B : rotated<B, N, q, N::z>, angular_velocity<N, u, N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n15

// expect: the angular velocity of frame B is a scalar; it must be a vector
namespace n16 {
struct B : rotated<B, N, q, N::z>, angular_velocity<N, u> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n16

// expect: frame B lacks an argument; write modified_rodrigues<Self, Parent, s1, s2, s3>
namespace n18 {
struct B : modified_rodrigues<B, N, q, q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n18

// expect: a modified Rodrigues parameter of frame B is a vector; it must be a scalar
namespace n19 {
struct B : modified_rodrigues<B, N, q, N::x, q> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n19

// expect: O, which B uses as a frame, is a point
namespace n17 {
struct B : rotated<B, O, q, N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n17
