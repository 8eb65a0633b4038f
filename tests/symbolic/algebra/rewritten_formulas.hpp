#pragma once

#include "symbolic/random_formula.hpp"

#include <kanexpr/symbolic/algebra/rewritten.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <gtest/gtest.h>

#include <cmath>

/// Rewrites thirty random formulas per seed and compares the values before and after. `rewrite` may fail for
/// some of them; returns the number of formulas for which it succeeded.
template <class Rewrite>
void expect_same_values(Rewrite rewrite, unsigned seeds, int& done) {
  done = 0;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    symbols s;
    random_formulas random(s, seed);
    for (int i = 0; i < 30; ++i) {
      const random_formulas::formula f = random.make(1 + i % 5);
      const kanexpr::symbolic::rewritten other = rewrite(f.e);
      if (!other) continue;
      ++done;
      for (std::size_t k = 0; k < random_formulas::points; ++k) {
        const long double tolerance = 1e-12L * (1 + std::abs(f.value[k])) + 1000 * f.error[k];
        ASSERT_PRED3(graph_evaluation::are_close, graph_evaluation::evaluate(other.value, random.point(k)),
                     f.value[k], tolerance)
            << seed << ' ' << i << ' ' << print(f.e);
      }
    }
  }
}
