#ifndef PEERS_SOLVE_H
#define PEERS_SOLVE_H

#include <math.h>

/* X in A X = B by elimination with row pivots. A stands row by row and is lost, B and X column by column. */
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
      const double other = B[j * n + k];
      B[j * n + k] = B[j * n + pivot];
      B[j * n + pivot] = other;
    }
    for (int i = k + 1; i < n; ++i) {
      const double ratio = A[i * n + k] / A[k * n + k];
      for (int j = k + 1; j < n; ++j) A[i * n + j] -= ratio * A[k * n + j];
      for (int j = 0; j < columns; ++j) B[j * n + i] -= ratio * B[j * n + k];
    }
  }
  for (int j = 0; j < columns; ++j)
    for (int k = n - 1; k >= 0; --k) {
      for (int i = k + 1; i < n; ++i) B[j * n + k] -= A[k * n + i] * B[j * n + i];
      B[j * n + k] /= A[k * n + k];
    }
}

#endif
