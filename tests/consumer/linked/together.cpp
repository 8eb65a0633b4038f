// Combines results that the library does not provide in this combination.
#include <linked_models.hpp>

int main() {
  using eom = kanexpr::equations_of_motion<models::Turning>;
  eom::together(eom::udot, eom::forcing)(eom::state(), eom::parameters(), eom::inputs());
}
