// expect: inertia_forces needs the rate of speed u: call it as inertia_forces(x, p, r, a)
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

constexpr auto F = equations_of_motion<System>::inertia_forces.constant({0.1, 0}, {2, 3}, {});

int main() {}
