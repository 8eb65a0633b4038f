#include "compiled.hpp"

extern "C" void udot(const double* x, double* result) {
  using namespace peers;
  Eigen::Map<row_major<speeds>>{result} = at(eom::udot, x);
}
