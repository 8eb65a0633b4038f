#include "models/andrews.hpp"
#include "models/bicycle.hpp"
#include "models/four_bar.hpp"
#include "side_by_side.hpp"

int main(int argc, char** argv) {
  side_by_side::add_system<four_bar::System>("four_bar");
  side_by_side::add_system<andrews::System>("andrews");
  side_by_side::add_system<bicycle::BoundSystem>("bicycle");
  return side_by_side::run(argc, argv);
}
