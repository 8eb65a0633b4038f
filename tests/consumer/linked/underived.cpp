// A file that does not derive anything and requests a result that the library does not contain.
#include <linked_models.hpp>

int main() {
  const kanexpr::state<models::Turning> x;
  kanexpr::function<models::Turning, kanexpr::velocity_of<models::Bob>>{}(x);
}
