#ifdef LINKED
#include <linked_models.hpp>

#include <kanexpr/compiled/named_values.hpp>
#else
#include <kanexpr/kanexpr.hpp>

#include "models.hpp"
#endif

#include "results.hpp"

void print_sliding();

int main() {
  using namespace models;
  results::print_all<Turning>({{q, 0.3}, {u, -1.2}}, {{T, 0.4}});
  print_sliding();
#ifdef LINKED // an omitted argument is NaN
  using eom = kanexpr::equations_of_motion<Turning>;
  const auto energy = eom::kinetic_energy(eom::state{{q, 0.3}, {u, -1.2}});
  if (energy.status || !energy.status.cause().starts_with("the result is not finite")) return 1;
  // and so are results that the system does not have
  using given = kanexpr::equations_of_motion<Given>;
  const given::state at{{q, 0.3}, {dot(q), -1.2}};
  const given::parameters values{{l, 0.7}, {m, 2}};
  const auto kinetic = given::kinetic_energy(at, values);
  if (kinetic.status ||
      !kinetic.status.cause().starts_with("energies, momenta, the mass center and the regressor"))
    return 2;
  const auto rates = given::udot(at, values);
  if (!rates.status || !(rates(0) < 0)) return 3;
  const kanexpr::given_parameters<Heavy> light{{l, 0.7}, {m, 0.5}};
  return light.mistake.view() == "the mass of Lump is negative" ? 0 : 4;
#endif
}
