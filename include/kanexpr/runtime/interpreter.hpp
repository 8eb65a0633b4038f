#pragma once

#include <kanexpr/lower/tape.hpp>
#include <kanexpr/lower/unrolled_elimination.hpp>

namespace kanexpr::runtime {

/// Evaluates a tape that is only known while the program runs: the steps of the compiled evaluation, in its
/// order and with its arithmetic, so the results agree to the last bit. All memory is taken once, by the
/// constructor.
template <class T = double>
class interpreter {
public:
  explicit interpreter(const lower::tape& code);

  const lower::tape& code() const { return code_; }
  int size() const { return code_.results.size(); }

  /// Writes `results[i]` for each result; `value_of(load)` gives the value of a symbol by its kind and
  /// position.
  template <class Arguments, class Results>
  void evaluate(const Arguments& value_of, Results&& results) {
    const int first_load = code_.numbers.size();
    for (int i = 0; i < code_.loads.size(); ++i) slots_[first_load + i] = value_of(code_.loads[i]);
    run();
    for (int i = 0; i < size(); ++i) results[i] = slots_[code_.results[i]];
  }

private:
  void run();
  void run(int begin, int end);
  static void run(const lower::instruction& step, const T* values, T* out);
  void eliminate(const lower::linear_step& e);

  lower::tape code_;
  symbolic::sequence<T> slots_;
  symbolic::sequence<T> squares_{}; ///< while they grow
};

// Not inside of the class: there they would be inline, and every file would compile them.

template <class T>
interpreter<T>::interpreter(const lower::tape& code)
    : code_(code), slots_(code.slot_count(), lower::scalar_math<T>::from(0)) {
  for (const lower::linear_step& e : code_.linear_steps)
    if (e.inputs() > squares_.size()) squares_.resize(e.inputs(), lower::scalar_math<T>::from(0));
  for (int i = 0; i < code_.numbers.size(); ++i) slots_[i] = lower::number_as<T>(code_.numbers[i]);
}

template <class T>
void interpreter<T>::run() {
  int next = 0;
  for (const lower::linear_step& e : code_.linear_steps) {
    run(next, e.step);
    eliminate(e);
    next = e.step + e.outputs();
  }
  run(next, code_.steps.size());
}

template <class T>
void interpreter<T>::run(int begin, int end) {
  const T* const values = slots_.begin();
  T* out = slots_.begin() + code_.first_step() + begin;
  for (int i = begin; i < end; ++i) run(code_.steps[i], values, out++);
}

template <class T>
void interpreter<T>::eliminate(const lower::linear_step& e) {
  using symbolic::operation;
  using math = lower::elimination_math<T>;
  T* const out = slots_.begin() + code_.first_step() + e.step;
  T* const into = e.op == operation::singularity_measure ? squares_.begin() : out;
  const T* const factors = slots_.begin() + e.factors;
  for (int i = 0; i < e.inputs(); ++i) into[i] = slots_[code_.operands[e.operands + i]];
  if (e.op == operation::factorization)
    numeric::factorize<math>(e.order, out);
  else if (e.op == operation::singularity_measure)
    *out = numeric::singularity_measure_of<math>(e.order, factors, into);
  else if (e.op == operation::solve)
    numeric::solve_factorized<math>(e.order, factors, out);
  else
    numeric::solve_transposed_factorized<math>(e.order, factors, out);
}

template <class T>
void interpreter<T>::run(const lower::instruction& step, const T* values, T* out) {
  using symbolic::operation;
  const T& a = values[step.a];
  const T& b = values[step.b];
  if (step.paired) {
    if (step.op == operation::sin) lower::scalar_math<T>::sincos(a, out[0], out[1]);
    return;
  }
  using symbolic::form;
  switch (symbolic::form_of(step.op)) {
  case form::negate: *out = lower::apply<operation::negate>(a, b); return;
  case form::add: *out = lower::apply<operation::add>(a, b); return;
  case form::subtract: *out = lower::apply<operation::subtract>(a, b); return;
  case form::multiply: *out = lower::apply<operation::multiply>(a, b); return;
  case form::divide: *out = lower::apply<operation::divide>(a, b); return;
  case form::power: *out = lower::apply<operation::power>(a, b); return;
  case form::atan2: *out = lower::apply<operation::atan2>(a, b); return;
  case form::function:
    symbolic::with_function(step.op, [&]<operation function>() { *out = lower::apply<function>(a, b); });
    return;
  case form::constant:
  case form::symbol: // are loaded before
  case form::pair:
  case form::factorization:
  case form::solve:
  case form::transposed_solve:
  case form::component:
  case form::singularity_measure: return; // belong to an elimination
  }
}

#if defined KANEXPR_COMPILED_ENGINE
extern template class interpreter<double>;
extern template class interpreter<float>;
#endif

} // namespace kanexpr::runtime
