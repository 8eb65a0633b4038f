// Writes the C of some models into the folder that it is given, as double.c, …, for the tests that compile
// it.
#include "bead.hpp"

#include <kanexpr/export.hpp>

#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/rolling_disc.hpp>
#include <models/simple_pendulum.hpp>
#include <steps/quaternions.hpp>

#include <iostream>

namespace {

using namespace kanexpr::exporting;

template <class System>
bool write(const char* folder, const char* name, c_options chosen) {
  chosen.number = precision::double_precision;
  kanexpr::outcome written = kanexpr::write_c<System>(folder, name, chosen);
  if (written) {
    chosen.number = precision::single_precision;
    written = kanexpr::write_c<System>(folder, name + std::string("_in_float"), chosen);
  }
  if (!written) std::cerr << written.cause() << '\n';
  return static_cast<bool>(written);
}

} // namespace

int main(int, char** arguments) {
  const char* const folder = arguments[1];
  c_options dynamics, with_python;
  with_python.with_python = with_python.with_cpp = true;
  dynamics.with_python = true;
  dynamics.functions = {results("udot"), results("inverse_dynamics")};
  c_options bound{
      {.functions = {results("udot"), results("mass_matrix forcing"),
                     expression<kanexpr::position_of<simple_pendulum::P, simple_pendulum::O>>("tip")},
       .bound = {{"g", 9.81}, {"m", 2}}},
      precision::single_precision};
  using namespace kanexpr;
  using namespace simple_pendulum;
#include <docs/export/c/write.cpp>
  const bool is_bound_written =
      written &&
      static_cast<bool>(kanexpr::write_c<simple_pendulum::System>(folder, "bound_pendulum", bound));
  c_options steps;
  steps.with_python = steps.with_cpp = true;
  steps.functions = {results("runge_kutta_4"), fixed_step("euler", {step_method::semi_implicit_euler, 2})};
  return is_bound_written && write<quaternions::Sliding>(folder, "sliding", steps) &&
                 write<bead::System>(folder, "bead", steps) &&
                 write<iiwa::System>(folder, "iiwa", dynamics) &&
                 write<four_bar::System>(folder, "four_bar", with_python) &&
                 write<rolling_disc::System>(folder, "disc", {})
             ? 0
             : 1;
}
