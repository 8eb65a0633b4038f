// expect: two frames are called Foot
#include "pendulum.hpp"

namespace left {
struct Foot : rotated<Foot, A, q, N::z> {};
} // namespace left
namespace right {
struct Foot : rotated<Foot, left::Foot, q, N::z> {};
} // namespace right
struct Rod : rigid_body<Rod, P, right::Foot, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
