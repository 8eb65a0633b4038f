#pragma once

#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/tape.hpp>

#include <cstddef>
#include <vector>

namespace kanexpr::runtime {

/// Evaluates a tape step by step while the program runs: the same operations in the same order as the compiled code.
/// Its memory is taken once, when it is made.
template <class Scalar>
class interpreter {
public:
  explicit interpreter(const lower::tape& code) : code_(code), slot_(static_cast<std::size_t>(code.slots())) {
    for (int i = 0; i < code.numbers.size(); ++i) at(i) = lower::number_as<Scalar>(code.numbers[i]);
  }

  int results() const { return code_.results.size(); }
  const lower::tape& code() const { return code_; }

  /// Evaluates; `value_of(load)` gives what each load stands for. Results are read with `result` afterwards.
  template <class ValueOf>
  void evaluate(const ValueOf& value_of) noexcept {
    int next = code_.numbers.size();
    for (const lower::load& l : code_.loads) at(next++) = value_of(l);
    for (const lower::instruction& step : code_.steps) {
      run(step, next);
      ++next;
    }
  }

  /// Evaluates at a time, a state [q; u], parameters, inputs and rates of the speeds; what the results do not need
  /// may be anything that is indexed.
  template <class X, class P, class R, class A>
  void operator()(const Scalar& t, const X& x, int coordinates, const P& p, const R& r, const A& a) noexcept {
    using symbolic::symbol_kind;
    evaluate([&](const lower::load& l) -> Scalar {
      switch (l.from) {
      case symbol_kind::coordinate: return Scalar(x[l.position]);
      case symbol_kind::speed: return Scalar(x[coordinates + l.position]);
      case symbol_kind::parameter: return Scalar(p[l.position]);
      case symbol_kind::input: return Scalar(r[l.position]);
      case symbol_kind::speed_rate: return Scalar(a[l.position]);
      default: return t;
      }
    });
  }

  const Scalar& result(int i) const { return slot_[static_cast<std::size_t>(code_.results[i])]; }

private:
  Scalar& at(int i) { return slot_[static_cast<std::size_t>(i)]; }

  void run(const lower::instruction& step, int slot) noexcept {
    using symbolic::operation;
    const Scalar &a = at(step.a), &b = at(step.b);
    switch (step.op) {
    case operation::negate: at(slot) = lower::apply<operation::negate>(a, b); break;
    case operation::add: at(slot) = lower::apply<operation::add>(a, b); break;
    case operation::subtract: at(slot) = lower::apply<operation::subtract>(a, b); break;
    case operation::multiply: at(slot) = lower::apply<operation::multiply>(a, b); break;
    case operation::divide: at(slot) = lower::apply<operation::divide>(a, b); break;
    case operation::power: at(slot) = lower::apply<operation::power>(a, b); break;
    case operation::sqrt: at(slot) = lower::apply<operation::sqrt>(a, b); break;
    case operation::sin:
      if (step.paired)
        lower::scalar_math<Scalar>::sincos(a, at(slot), at(slot + 1));
      else
        at(slot) = lower::apply<operation::sin>(a, b);
      break;
    case operation::cos:
      if (!step.paired) at(slot) = lower::apply<operation::cos>(a, b);
      break;
    case operation::tan: at(slot) = lower::apply<operation::tan>(a, b); break;
    case operation::asin: at(slot) = lower::apply<operation::asin>(a, b); break;
    case operation::acos: at(slot) = lower::apply<operation::acos>(a, b); break;
    case operation::atan: at(slot) = lower::apply<operation::atan>(a, b); break;
    case operation::atan2: at(slot) = lower::apply<operation::atan2>(a, b); break;
    case operation::exp: at(slot) = lower::apply<operation::exp>(a, b); break;
    case operation::log: at(slot) = lower::apply<operation::log>(a, b); break;
    case operation::abs: at(slot) = lower::apply<operation::abs>(a, b); break;
    case operation::sign: at(slot) = lower::apply<operation::sign>(a, b); break;
    case operation::constant:
    case operation::symbol: break;
    }
  }

  lower::tape code_;
  std::vector<Scalar> slot_;
};

} // namespace kanexpr::runtime
