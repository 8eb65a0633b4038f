// expect: frame Elsewhere in formulation<...> belongs to no part of the system
#include "pendulum.hpp"

struct Elsewhere : rotated<Elsewhere, N, q, N::z> {};
struct System : bound_pendulum<formulation<written_in<Elsewhere, N>>> {};

int main() { use<System>(); }
