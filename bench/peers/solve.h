#ifndef PEERS_SOLVE_H
#define PEERS_SOLVE_H

#include <math.h>

/* X in A X = B by elimination with row pivots: n rows, in place of B; A is lost. */
static inline void solve(double* A, double* B, int n, int columns) {
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (fabs(A[i * n + k]) > fabs(A[pivot * n + k])) pivot = i;
    for (int j = k; j < n && pivot != k; ++j) {
      const double other = A[k * n + j];
      A[k * n + j] = A[pivot * n + j];
      A[pivot * n + j] = other;
    }
    for (int j = 0; j < columns && pivot != k; ++j) {
      const double other = B[k * columns + j];
      B[k * columns + j] = B[pivot * columns + j];
      B[pivot * columns + j] = other;
    }
    for (int i = k + 1; i < n; ++i) {
      const double ratio = A[i * n + k] / A[k * n + k];
      for (int j = k + 1; j < n; ++j) A[i * n + j] -= ratio * A[k * n + j];
      for (int j = 0; j < columns; ++j) B[i * columns + j] -= ratio * B[k * columns + j];
    }
  }
  for (int k = n - 1; k >= 0; --k)
    for (int j = 0; j < columns; ++j) {
      for (int i = k + 1; i < n; ++i) B[k * columns + j] -= A[k * n + i] * B[i * columns + j];
      B[k * columns + j] /= A[k * n + k];
    }
}

#endif
