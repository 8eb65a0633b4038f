// Prints results beside their reference and remembers whether one of them was missed.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdio>

class report {
public:
  report(const char* system, double tolerance) : tolerance_(tolerance) { std::printf("%s\n", system); }

  void operator()(const char* what, double result, double reference) {
    (*this)(what, Eigen::Matrix<double, 1, 1>(result), Eigen::Matrix<double, 1, 1>(reference));
  }

  template <class Result, class Reference>
  void operator()(const char* what, const Eigen::MatrixBase<Result>& result,
                  const Eigen::MatrixBase<Reference>& reference) {
    const double error = (result - reference).cwiseAbs().maxCoeff() / reference.cwiseAbs().maxCoeff();
    std::printf("  %s, relative error %.1e\n", what, error);
    for (Eigen::Index i = 0; i < result.rows(); ++i)
      for (Eigen::Index j = 0; j < result.cols(); ++j)
        std::printf("    %24.16g %24.16g\n", result(i, j), reference(i, j));
    if (!(error <= tolerance_)) missed_ = true;
  }

  void at_most(const char* what, double size, double bound) {
    std::printf("  %s %.1e, at most %.1e\n", what, size, bound);
    if (!(std::abs(size) <= bound)) missed_ = true;
  }

  // What main returns.
  int exit_code() const { return missed_ ? 1 : 0; }

private:
  double tolerance_;
  bool missed_ = false;
};
