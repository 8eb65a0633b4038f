// expect: the angular velocity of frame D does not match its orientation, and no omitted angle explains the
// expect: difference; if this is intended, write angular_velocity_apart
#include "pendulum.hpp"

constexpr coordinate<"lean"> lean;
constexpr coordinate<"spin"> spin;
constexpr speed<"w"> w;

// The speeds are intended along the axes of the leaning frame, and the rate of q along a different axis.
struct L : rotated<L, A, lean, A::x> {};
struct D : rotated<D, L, spin, L::y>, angular_velocity<N, u * L::x + v * L::y + w * L::z> {};
struct Disc : rigid_body<Disc, P, D, m, inertia<D, 1, 2, 1>> {};

struct System : kane_system<inertial<N>, coordinates<q, lean, spin>, speeds<u, v, w>,
                            kinematics<dot(lean) == u, dot(q) == w, dot(spin) == v>, bodies<Disc>> {};

int main() { use<System>(); }
