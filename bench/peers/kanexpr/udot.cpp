#include "compiled.hpp"

extern "C" void udot(const peers::number* x, peers::number* result) {
  using namespace peers;
  Eigen::Map<Eigen::Matrix<number, speeds, 1>>{result} = at(eom::udot, x);
}
