// The operations of a compiled robot, and how far its results are from those of the same robot at run time:
// compiled < what results prints.
#include ROBOT_HEADER

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>

namespace {

using namespace kanexpr;
using System = ROBOT::System;
using eom = equations_of_motion<System>;

constexpr int operations(const symbolic::cost& c) { return c.multiplications + c.additions; }

template <class Vector>
Vector read(std::istream& numbers) {
  Vector v;
  for (Eigen::Index i = 0; i < v.size(); ++i) numbers >> v.data()[i];
  return v;
}

constexpr auto mass_and_forcing = eom::together(eom::mass_matrix, eom::forcing);

/// Of a vector or a symmetric matrix, relative to the largest entry.
template <class Matrix>
double apart(const Matrix& ours, std::istream& numbers) {
  const Matrix theirs = read<Matrix>(numbers);
  return (ours - theirs).cwiseAbs().maxCoeff() / theirs.cwiseAbs().maxCoeff();
}

} // namespace

int main() {
  state<System> x;
  input_values<System> r;
  const parameter_values<System> p;
  double worst = 0;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "state") x = read<state<System>>(words);
    if (what == "inputs") r = read<input_values<System>>(words);
    const auto [mass, forcing] = mass_and_forcing(x, p, r);
    if (what == "mass") worst = std::max(worst, apart(mass, words));
    if (what == "forcing") worst = std::max(worst, apart(forcing, words));
    if (what == "udot") worst = std::max(worst, apart(eom::udot(x, p, r), words));
  }
  std::cout << operations(eom::cost(mass_and_forcing)) << '\t' << operations(eom::cost(eom::udot)) << '\t'
            << worst << '\n';
}
