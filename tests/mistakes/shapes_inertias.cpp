// Invalid inertias and orientations.
#include "shapes.hpp"

constexpr parameter<"a"> a;

// expect: the inertia of Rod is not symmetric
namespace n1 {
struct Rod : rigid_body<Rod, P, A, m, inertia_dyadic<outer(A::x, N::z) + m * outer(A::z, A::z)>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n1

// expect: the inertia of Rod is indefinite: its moment about some axis is negative
namespace n2 {
struct Rod : rigid_body<Rod, P, A, m,
                        inertia_dyadic<outer(A::x, A::x) + outer(A::y, A::y) - 5 * outer(N::z, N::z)>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n2

// expect: the inertia of Rod is indefinite: its moment about some axis is negative
namespace n3 {
struct B : rotated<B, A, 1, A::y> {};
struct Rod : rigid_body<Rod, P, A, m, inertia_dyadic<outer(A::x, A::x) - 2 * outer(B::z, B::z)>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n3

// expect: the inertia of Rod about O is smaller than the parallel-axis term of its mass
namespace n4 {
struct Rod : rigid_body<Rod, P, A, 2, inertia_about<O, inertia<A, 0, 1, 1>>> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Rod>,
                            values<l == 10>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the quaternion of frame B does not have unit length
namespace n5 {
struct B : quaternion<B, A, 0, 0, 0, 0> {};
struct System : loaded<torque<B, T * N::z>> {};
void f() { use<System>(); }
} // namespace n5

// expect: the quaternion of frame B does not have unit length
namespace n6 {
struct B : quaternion<B, A, a, 0, 0, 0> {};
struct System : told<loads<torque<B, T * N::z>>, values<a == 2>> {};
void f() { use<System>(); }
} // namespace n6

// expect: the quaternion of frame B does not have unit length
namespace n7 {
struct B : quaternion<B, N, cos(q), 0, 0, 2 * sin(q)> {};
struct System : loaded<torque<B, T * N::z>> {};
void f() { use<System>(); }
} // namespace n7

// expect: the direction cosines of frame B are not orthonormal
namespace n8 {
struct B : direction_cosines<B, N, cos(q), -sin(q), 0, sin(q), -cos(q), 0, 0, 0, 1> {};
struct System : loaded<torque<B, T * N::z>> {};
void f() { use<System>(); }
} // namespace n8

// expect: the direction cosines of frame B are not right-handed: they describe a reflection
namespace n9 {
struct B : direction_cosines<B, N, cos(q), -sin(q), 0, sin(q), cos(q), 0, 0, 0, -1> {};
struct System : loaded<torque<B, T * N::z>> {};
void f() { use<System>(); }
} // namespace n9

// Valid: a product and its reverse, a rod with zero inertia about its axis, and cosines that are normalized
// by their factor.
namespace n10 {
struct Rod
    : rigid_body<Rod, P, A, m,
                 inertia_dyadic<m * outer(A::y, A::y) + m * outer(A::z, N::z) + (m / 4) * outer(A::x, N::z) +
                                (m / 4) * outer(N::z, A::x) + m * outer(A::x, A::x)>> {};
struct B : direction_cosines<B, N, a * cos(q), -a * sin(q), 0, sin(q), cos(q), 0, 0, 0, 1> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Rod>,
                            loads<torque<B, T * N::z>>> {};
void f() { use<System>(); }
} // namespace n10
