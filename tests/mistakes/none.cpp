// The control program: it contains no mistake, so it must compile.
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};

int main() { use<System>(); }

// An expression without a value at the states at which loads and declarations are compared numerically is not
// a mistake.
namespace undefined {
constexpr parameter<"k"> k;
struct B : rotated<B, A, acos(q - 5), A::z>, angular_velocity<A, u / sqrt(1 - (q - 5) * (q - 5)) * A::z> {};
struct Q : offset<Q, O, sqrt(q - 5) * A::y>, velocity<A, u / (2 * sqrt(q - 5)) * A::y> {};
struct Bead : particle<Bead, Q, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bead>,
                            loads<gravity<-g * N::y>, force<Q, m * sqrt(q - 5) * g * N::y>,
                                  potential_energy<m * g * sqrt(q - 5)>, torsional_spring<q, k>,
                                  potential_energy<k * sqrt(q - 4)>, torque<B, T * N::z>>> {};
void f() { use<System>(); }
} // namespace undefined

// Nor is a load that cancels a weight or acts on several bodies.
namespace sound {
struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                  loads<gravity<-g * N::y>, force<P, m * g * N::y>, potential_energy<-m * g * l * sin(q)>,
                        torque<A, T * N::z>, torque_between<A, N, 2 * T * N::z>, force<O, -m * g * N::y>>> {};
void f() { use<System>(); }
} // namespace sound
