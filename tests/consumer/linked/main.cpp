#ifdef LINKED
#include <linked_models.hpp>
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
#ifdef LINKED // an argument that is left out is not a number
  using eom = kanexpr::equations_of_motion<Turning>;
  const auto energy = eom::kinetic_energy(eom::state{{q, 0.3}, {u, -1.2}});
  return energy.status || !energy.status.cause().starts_with("the result is not finite") ? 1 : 0;
#endif
}
