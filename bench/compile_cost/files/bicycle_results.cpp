#include <models/bicycle.hpp>

using eom = kanexpr::equations_of_motion<bicycle::System>;

auto accelerations(const eom::state& x, const eom::parameters& p, const eom::inputs& r) {
  return eom::udot(x, p, r);
}
auto mass_matrix(const eom::state& x, const eom::parameters& p) { return eom::mass_matrix(x, p); }
auto forcing(const eom::state& x, const eom::parameters& p, const eom::inputs& r) {
  return eom::forcing(x, p, r);
}
auto configuration_residual(const eom::state& x, const eom::parameters& p) {
  return eom::configuration_residual(x, p);
}
auto velocity_residual(const eom::state& x, const eom::parameters& p) { return eom::velocity_residual(x, p); }
auto configuration_jacobian_by_dependent(const eom::state& x, const eom::parameters& p) {
  return eom::configuration_jacobian_by_dependent(x, p);
}
auto constraint_jacobian(const eom::state& x, const eom::parameters& p) {
  return eom::constraint_jacobian(x, p);
}
