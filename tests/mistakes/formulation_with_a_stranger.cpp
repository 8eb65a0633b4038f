// expect: Rod is not a part of formulation<...>; it takes written_in<frame, axes>, about_mass_center<frame>,
// expect: by_elimination, by_articulated_bodies, in_absolute_speeds and weighted_by<weights>
#include "pendulum.hpp"

struct Rod : rotated<Rod, N, q, N::z> {};
struct System : bound_pendulum<formulation<Rod>> {};

int main() { use<System>(); }
