#include <linked_pendulum.hpp>

using eom = kanexpr::equations_of_motion<pendulum::System>;

double acceleration(const eom::state& x, const eom::parameters& p) { return eom::udot(x, p)(0); }
