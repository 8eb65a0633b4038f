#ifdef LINKED
#include <linked_models.hpp>
#else
#include <kanexpr/kanexpr.hpp>

#include "models.hpp"
#endif

#include "results.hpp"

static_assert(kanexpr::equations_of_motion<models::Sliding>::is_dependent(models::vx));

void print_sliding() {
  using namespace models;
  results::print_all<Sliding>({{x, 0.56}, {y, 0.42}, {vx, -0.3}, {vy, 0.4}}, {});
  results::print_failure<Sliding>();
}
