#include <models/bicycle.hpp>

using eom = kanexpr::equations_of_motion<bicycle::System>;

auto accelerations(const eom::state& x, const eom::parameters& p, const eom::inputs& r) {
  return eom::udot(x, p, r);
}
