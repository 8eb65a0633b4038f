#pragma once

#include <kanexpr/lower/eliminate.hpp>
#include <kanexpr/lower/tape.hpp>

namespace kanexpr::lower {

/// Looks at straight-line code step by step, over slots that stand elsewhere: what the compiled evaluation
/// does, in its order and with its arithmetic, so the results agree to the last bit. `Code` is a tape or the
/// view of one.
template <class Code, class T>
class interpretation {
public:
  /// `squares`: room for as many numbers as `squares_of` says.
  interpretation(const Code& code, T* slots, T* squares) : code_(code), slots_(slots), squares_(squares) {}

  static int squares_of(const Code& code) {
    int most = 0;
    for (const elimination& e : code.eliminations)
      if (e.inputs() > most) most = e.inputs();
    return most;
  }

  /// Once, before the first evaluation.
  void place_numbers() {
    for (int i = 0; i < code_.numbers.size(); ++i) slots_[i] = number_as<T>(code_.numbers[i]);
  }

  /// All steps; what is loaded stands in its slots.
  void run() {
    int next = 0;
    for (const elimination& e : code_.eliminations) {
      run(next, e.step);
      eliminate(e);
      next = e.step + e.outputs();
    }
    run(next, code_.steps.size());
  }

private:
  void run(int begin, int end) {
    T* out = slots_ + code_.first_step() + begin;
    for (int i = begin; i < end; ++i) run(code_.steps[i], out++);
  }

  void eliminate(const elimination& e) {
    using math = elimination_math<T>;
    T* const out = slots_ + code_.first_step() + e.step;
    T* const into = e.op == operation::regularity ? squares_ : out;
    const T* const factors = slots_ + e.factors;
    for (int i = 0; i < e.inputs(); ++i) into[i] = slots_[code_.operands[e.operands + i]];
    if (e.op == operation::factorization)
      numeric::factorize<math>(e.order, out);
    else if (e.op == operation::regularity)
      *out = numeric::regularity_of<math>(e.order, factors, into);
    else if (e.op == operation::solve)
      numeric::solve_factorized<math>(e.order, factors, out);
    else
      numeric::solve_transposed_factorized<math>(e.order, factors, out);
  }

  void run(const instruction& step, T* out) {
    const T& a = slots_[step.a];
    const T& b = slots_[step.b];
    if (step.paired) {
      if (step.op == operation::sin) scalar_math<T>::sincos(a, out[0], out[1]);
      return;
    }
    using symbolic::form;
    switch (symbolic::form_of(step.op)) {
    case form::negate: *out = apply<operation::negate>(a, b); return;
    case form::add: *out = apply<operation::add>(a, b); return;
    case form::subtract: *out = apply<operation::subtract>(a, b); return;
    case form::multiply: *out = apply<operation::multiply>(a, b); return;
    case form::divide: *out = apply<operation::divide>(a, b); return;
    case form::power: *out = apply<operation::power>(a, b); return;
    case form::atan2: *out = apply<operation::atan2>(a, b); return;
    case form::function:
      symbolic::with_function(step.op, [&]<operation function>() { *out = apply<function>(a, b); });
      return;
    case form::constant:
    case form::symbol: // are loaded before
    case form::pair:
    case form::factorization:
    case form::solve:
    case form::transposed_solve:
    case form::component:
    case form::regularity: return; // belong to an elimination
    }
  }

  const Code& code_;
  T* slots_;
  T* squares_;
};

} // namespace kanexpr::lower
