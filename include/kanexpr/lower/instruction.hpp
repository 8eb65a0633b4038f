#pragma once

#include <kanexpr/base/zeros.hpp>
#include <kanexpr/numeric/elimination.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::lower {

using symbolic::operation;

/// One step of straight-line code: slot = op(slot a, slot b).
struct instruction {
  operation op;
  int a;
  int b;
  bool paired; ///< a sine followed by the cosine of its angle in the next slot, or that cosine
};

/// A step that fills several slots, either part of the solution of a linear system or a function call.
/// Starting at `step`, it fills as many slots as its operation requires; the list of steps marks them as its
/// components.
struct linear_step {
  operation op = operation::factorization;
  int order = 0; ///< for a call: the number of operands
  int step = 0;
  int factors = 0;  ///< the first slot of the factorization that it uses; for a call: the index of the
                    ///< function; for a symmetric system: the number of columns
  int operands = 0; ///< the index of its first operand among those of all linear steps

  constexpr int inputs() const {
    if (op == operation::symmetric_solve) return numeric::symmetric_factors{order}.size() + order * factors;
    return op == operation::factorization || op == operation::singularity_measure ? order * order : order;
  }
  constexpr int outputs() const {
    if (op == operation::symmetric_solve) return order * factors;
    if (op == operation::factorization) return numeric::factors{order}.size();
    return op == operation::singularity_measure || op == operation::call ? 1 : order;
  }
};

/// The source of the value of a slot that is filled before the first step.
struct load {
  symbolic::symbol_kind from{};
  int position = 0;
};

/// Steps in constant evaluation, as one array for each member, which base::zeros explains.
struct constant_steps {
  static constexpr int room = base::zeros<int>::room;

  base::zeros<operation> op{room};
  base::zeros<int> a{room}, b{room};
  base::zeros<char> paired{room};
  int count = 0;

  constexpr int size() const { return count; }
};

} // namespace kanexpr::lower
