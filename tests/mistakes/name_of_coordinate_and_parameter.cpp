// expect: the name q is used twice: among the coordinates and among the parameters
#include "pendulum.hpp"

constexpr parameter<"q"> charge;
struct Ball : particle<Ball, P, charge> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
