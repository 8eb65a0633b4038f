#pragma once

#include <kanexpr/lower/evaluate_steps.hpp>

namespace kanexpr::runtime {

/// Evaluates a tape that is only known while the program runs: the steps of the compiled evaluation, in its
/// order and with its arithmetic, so the results agree to the last bit. All memory is taken once, by the
/// constructor.
template <class Number = double>
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

  lower::tape code_;
  symbolic::sequence<Number> slots_;
  symbolic::sequence<Number> aside_; ///< what a step works on
};

// Not inside of the class: there they would be inline, and every file would compile them.

template <class Number>
interpreter<Number>::interpreter(const lower::tape& code)
    : code_(code), slots_(code.slot_count(), lower::scalar_math<Number>::from(0)),
      aside_(lower::aside_of(code), lower::scalar_math<Number>::from(0)) {
  for (int i = 0; i < code_.numbers.size(); ++i) slots_[i] = lower::number_as<Number>(code_.numbers[i]);
}

template <class Number>
void interpreter<Number>::run() {
  lower::evaluate_steps(code_, slots_.begin(), aside_.begin());
}

#if defined KANEXPR_COMPILED_ENGINE
extern template class interpreter<double>;
extern template class interpreter<float>;
#endif

} // namespace kanexpr::runtime
