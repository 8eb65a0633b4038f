// expect: required inputs are defined only if the inputs act on all independent speeds; these do not
#include "pendulum.hpp"

constexpr input<"F"> F;
struct System : bound_pendulum<inputs<T, F>, loads<torque<A, (T + F) * N::z>>> {};
using eom = equations_of_motion<System>;

int main() { eom::required_inputs(eom::state(), eom::parameters(), eom::inputs(), Eigen::Vector2d(1, 1)); }
