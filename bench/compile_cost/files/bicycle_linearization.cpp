#include <models/bicycle.hpp>

using linear = kanexpr::linearization<bicycle::System>;

auto linearized(const linear::state& x, const linear::parameters& p, const linear::inputs& r) {
  return linear::explicit_form(x, p, r);
}
