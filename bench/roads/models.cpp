// Writes the models that with_casadi.py and timing.py use into the folder that it is given.
#include "../peers/kanexpr/model_numbers.hpp"
#include "vehicle.hpp"

#include <kanexpr/export.hpp>
#include <models/chaplygin_sleigh.hpp>
#include <models/double_pendulum.hpp>
#include <models/iiwa.hpp>
#include <models/n_pendulum_cart.hpp>

#include <fstream>
#include <iostream>
#include <string>

namespace {

template <class System>
bool write(const char* folder, const char* name, const kanexpr::exporting::casadi_options& chosen = {}) {
  const kanexpr::outcome written = kanexpr::write_casadi<System>(folder, name, chosen);
  if (!written) std::cerr << written.cause() << '\n';
  return static_cast<bool>(written);
}

} // namespace

/// What Pinocchio builds the same robot from.
bool write_numbers(const std::string& path) {
  std::ofstream file(path);
  file.precision(17);
  return peers::write_tree(file, iiwa::System::record) && file;
}

int main(int, char** arguments) {
  const char* const folder = arguments[1];
  return write<n_pendulum_cart::System<1>>(folder, "cart", {{{"g", 9.81}}}) &&
                 write<double_pendulum::System>(folder, "double_pendulum") &&
                 write<chaplygin_sleigh::System>(folder, "sleigh") &&
                 write<vehicle::System>(folder, "vehicle") && write<iiwa::System>(folder, "iiwa") &&
                 write_numbers(std::string(folder) + "/iiwa.model")
             ? 0
             : 1;
}
