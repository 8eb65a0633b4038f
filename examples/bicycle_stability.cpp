// A bicycle without a steering torque falls over at some speeds and is self-stable at others. The compiler
// derives its nonlinear equations by Kane's method and linearizes them; the program computes the eigenvalues.
#include "bicycle_modes.hpp"
#include "print.hpp"

#include <cstdio>

namespace {

using bicycle::modes_at;

// One row for each speed: the two weave eigenvalues with their real and imaginary parts, capsize, castering.
void tabulate(std::FILE* out, int rows) {
  std::fprintf(out, "#  m/s            weave 1            weave 2    capsize  castering\n");
  for (int i = 0; i <= rows; ++i) {
    const double v = 10.0 * i / rows;
    const auto [weave, capsize, castering] = modes_at(v);
    std::fprintf(out, "%6.2f %9.4f %8.4f %9.4f %8.4f %10.4f %10.4f\n", v, weave[0].real(), weave[0].imag(),
                 weave[1].real(), weave[1].imag(), capsize, castering);
  }
}

} // namespace

// Writes the data for bicycle_stability.gp to a file, if one is specified.
int main(int count, char** names) {
  tabulate(stdout, 10);
  const double weave_speed = bicycle::weave_speed(), capsize_speed = bicycle::capsize_speed();
  const auto [weave, capsize, castering] = modes_at(5);
  print("weave, capsize, castering at 5 m/s",
        Eigen::Vector4d{weave[0].real(), weave[0].imag(), capsize, castering});
  print("stable from", weave_speed);
  print("stable up to", capsize_speed);

  if (count > 1) {
    std::FILE* data = std::fopen(names[1], "w");
    if (data == nullptr) return 1;
    tabulate(data, 500);
    std::fprintf(data, "\n\n%.4f %.4f\n", weave_speed, capsize_speed);
    std::fclose(data);
  }
}
