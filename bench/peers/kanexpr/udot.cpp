#include "compiled.hpp"

extern "C" void udot(const double* x, double* result) {
  using namespace peers;
  Eigen::Map<Eigen::Matrix<double, speeds, 1>>{result} = at(eom::udot, x);
}
