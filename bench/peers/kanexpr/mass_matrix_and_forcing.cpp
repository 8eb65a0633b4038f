#include "compiled.hpp"

#include <new>

/// Leaves the results where the function gives them, in one object.
extern "C" void mass_matrix_and_forcing(const peers::number* x, peers::number* result) {
  new (result) auto(peers::at(peers::mass_matrix_and_forcing, x));
}

/// Where in that each of the results begins, and how many entries it has.
extern "C" void mass_matrix_and_forcing_places(int* place) {
  const peers::number x[peers::states + peers::inputs]{};
  const auto all = peers::at(peers::mass_matrix_and_forcing, x);
  const auto begin = reinterpret_cast<const peers::number*>(&all);
  std::apply(
      [&](const auto&... each) {
        ((*place++ = static_cast<int>(each.data() - begin), *place++ = static_cast<int>(each.size())), ...);
      },
      all);
}
