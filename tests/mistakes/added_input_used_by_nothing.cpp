// expect: input F is listed and nothing in the system uses it; if that is meant, write used_elsewhere<F>
#include "pendulum.hpp"

constexpr input<"F"> F;
struct System : extended<pendulum_with<Bob>, inputs<T, F>, loads<torque<A, T * N::z>>> {};

int main() { use<System>(); }
