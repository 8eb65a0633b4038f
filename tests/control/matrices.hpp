// Reference numbers as matrices.
#pragma once

#include <kanexpr/numeric/as_eigen.hpp>

#include <gtest/gtest.h>

namespace references {

template <class T, int rows, int columns>
constexpr auto fixed(const double (&written)[rows][columns]) {
  kanexpr::numeric::fixed_matrix<T, rows, columns> m;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) m(i, j) = static_cast<T>(written[i][j]);
  return m;
}
template <class T = double, int rows, int columns>
auto eigen(const double (&written)[rows][columns]) {
  return kanexpr::numeric::as_eigen(fixed<T>(written));
}

// Relative to the largest entry.
template <class Found, class Expected>
testing::AssertionResult close(const Found& found, const Expected& expected, double relative) {
  const double off = (found - expected).cwiseAbs().maxCoeff(), size = expected.cwiseAbs().maxCoeff();
  if (off <= relative * size) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "off by " << off / size << ":\n" << found << "\nnot\n" << expected;
}

} // namespace references
