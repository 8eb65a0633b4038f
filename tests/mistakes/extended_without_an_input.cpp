// expect: input G, which the force at P contains, comes after those that extended<...> adds; list it in
// expect: inputs<...>
#include "pendulum.hpp"

constexpr input<"F"> F;
constexpr input<"G"> G;
struct System : extended<pendulum_with<Bob>, inputs<F>, loads<force<P, F * N::x>, force<P, G * N::y>>> {};

int main() { use<System>(); }
