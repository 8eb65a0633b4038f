// expect: mass_matrix needs the parameter m: call it as mass_matrix(x, p)
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

constexpr auto M = equations_of_motion<System>::mass_matrix.constant({0.1, 0});

int main() {}
