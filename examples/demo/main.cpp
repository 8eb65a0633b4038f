#include "demo/parts.hpp"

#include <cstdio>
#include <filesystem>

/// Systems from their types to equations, numbers, figures and moving pictures: demo FOLDER.
int main(int count, char** words) {
  const std::string folder = count > 1 ? words[1] : ".";
  std::filesystem::create_directories(folder);
  std::vector<demo::exhibit> all;
  bool right = true;
  for (const auto part :
       {demo::show_double_pendulum, demo::show_rolling_disc, demo::show_iiwa, demo::show_bicycle})
    right = part() && right;
  for (const auto part : {demo::draw_systems, demo::show_rides, demo::show_eigenvalues})
    right = part(folder, all) && right;
  right = demo::write_index(folder, all) && right;
  if (!right) std::fprintf(stderr, "\nThe demo found results that differ from those expected; see above.\n");
  return right ? 0 : 1;
}
