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
}
