#include "models/iiwa.hpp"
#include "models/puma.hpp"
#include "models/quadruped.hpp"
#include "side_by_side.hpp"

int main(int argc, char** argv) {
  side_by_side::add_system<puma::System>("puma");
  side_by_side::add_system<iiwa::System>("iiwa");
  side_by_side::add_system<quadruped::System>("quadruped");
  return side_by_side::run(argc, argv);
}
