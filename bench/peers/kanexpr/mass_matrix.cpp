#include "compiled.hpp"

extern "C" void mass_matrix(const peers::number* x, peers::number* result) {
  using namespace peers;
  Eigen::Map<Eigen::Matrix<number, speeds, speeds>>{result} = at(eom::mass_matrix, x);
}
