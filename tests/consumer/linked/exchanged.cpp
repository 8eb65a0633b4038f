// Passes parameters in place of the state.
#include <linked_models.hpp>

int main() {
  using eom = kanexpr::equations_of_motion<models::Turning>;
  eom::udot(eom::parameters(), eom::parameters(), eom::inputs());
}
