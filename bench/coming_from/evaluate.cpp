// Reads states, inputs after coordinates and speeds, one a line, and prints the rates of the speeds of a
// system of docs/coming-from; with DERIVATIVES, also their derivatives with respect to the state, row by row.
// PROGRAM is the program of the page, SYSTEM its system, and NUMBERS the values of its parameters.
#define main program_of_the_page
#include PROGRAM
#undef main

#include <cstdio>
#include <iostream>

namespace {

bool read(auto& values) {
  for (double& value : values)
    if (!(std::cin >> value)) return false;
  return true;
}

void print(const auto& values) {
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    for (Eigen::Index k = 0; k < values.cols(); ++k) std::printf("%.17g ", values(i, k));
}

} // namespace

int main() {
  using namespace kanexpr;
  state<SYSTEM> x;
  input_values<SYSTEM> r;
  while (read(x) && read(r)) {
    print(equations_of_motion<SYSTEM>::udot(x, NUMBERS, r));
#ifdef DERIVATIVES
    const auto derivatives = linearization<SYSTEM>::jacobian(x, NUMBERS, r);
    print(std::get<0>(derivatives).bottomRows(x.u().size()).eval());
#endif
    std::puts("");
  }
}
