// expect: input F is listed, but nothing in the system uses it; if this is intended, write used_elsewhere<F>
#include "pendulum.hpp"

constexpr input<"F"> F;
struct System : extended<pendulum_with<Bob>, inputs<T, F>, loads<torque<A, T * N::z>>> {};

int main() { use<System>(); }
