#include "compiled.hpp"

/// The rows of u̇ of A and B: its derivatives by the independent coordinates and speeds and by the inputs.
extern "C" void udot_derivatives(const double* x, double* result) {
  using namespace peers;
  using linear = kanexpr::linearization<model>;
  constexpr int rows = speeds - kanexpr::compiled::survey_of<model>.constraints;
  const auto [A, B] = at(linear::explicit_form, x);
  Eigen::Map<Eigen::Matrix<double, rows, linear::states + inputs>> all{result};
  all.template leftCols<linear::states>() = A.template bottomRows<rows>();
  if constexpr (inputs != 0) all.template rightCols<inputs>() = B.template bottomRows<rows>();
}
