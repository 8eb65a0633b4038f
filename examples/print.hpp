// Prints a result after its name, and a matrix row by row.
#pragma once

#include <Eigen/Core>

#include <cstdio>

inline void print(const char* what, double result) { std::printf("%s: %.6g\n", what, result); }

template <class Result>
void print(const char* what, const Eigen::MatrixBase<Result>& result) {
  if (result.cols() == 1) {
    std::printf("%s:", what);
    for (Eigen::Index i = 0; i < result.rows(); ++i) std::printf(" %.6g", result(i));
    std::printf("\n");
    return;
  }
  std::printf("%s:\n", what);
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j < result.cols(); ++j) std::printf(" %12.6g", result(i, j));
    std::printf("\n");
  }
}
