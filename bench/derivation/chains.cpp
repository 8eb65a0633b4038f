// How many operations u̇ of a chain takes by the elimination of M and by articulated bodies.
#include "mechanics/rod_chain.hpp"

#include <cstdio>

int main() {
  std::printf(
      "links\tin a plane: elimination\tarticulated bodies\tin space: elimination\tarticulated bodies\n");
  for (const int links : {4, 7, 8, 12, 16, 32}) {
    const rod_chain::counted_forms plane(links, rod_chain::joints::in_plane),
        space(links, rod_chain::joints::in_space);
    std::printf("%d\t%d\t%d\t%d\t%d\n", links, plane.by_elimination, plane.by_articulated_bodies,
                space.by_elimination, space.by_articulated_bodies);
  }
}
