// Combines more results in a call than the library provides.
#include <linked_models.hpp>

int main() {
  using eom = kanexpr::equations_of_motion<models::Turning>;
  eom::together(eom::mass_matrix, eom::forcing, eom::udot);
}
