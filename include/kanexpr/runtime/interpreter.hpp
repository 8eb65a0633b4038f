#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/evaluate_steps.hpp>
#include <kanexpr/lower/scalar_math.hpp>

namespace kanexpr::runtime {

/// Evaluates a tape that is known only at run time. It performs the same steps in the same order and
/// arithmetic as compiled code, so the results agree to the last bit. The constructor allocates all memory.
template <class Number = double>
class interpreter {
public:
  explicit interpreter(const lower::tape& code);

  const lower::tape& code() const { return code_; }
  int size() const { return code_.results.size(); }

  /// Writes `results[i]` for each result; `value_of(load)` returns the value of a symbol by its kind and
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
  base::sequence<Number> slots_;
  base::sequence<Number> aside_; ///< working memory of a step
};

// These members are defined outside the class; inside it they would be inline, and every file would compile
// them.

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
