// A file that derives nothing and asks for a result which the library does not hold.
#include <linked_models.hpp>

int main() {
  const kanexpr::state<models::Turning> x;
  kanexpr::function<models::Turning, kanexpr::velocity_of<models::Bob>>{}(x);
}
