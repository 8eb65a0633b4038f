#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/symbolic/elementary.hpp>

#include <array>

/// Evaluation inside a constant expression, where neither Eigen nor the C library can go.
namespace kanexpr::lower {

/// A result as a plain constant: `m(i, j)`, and a number where it is one.
template <int rows, int columns>
struct constant_matrix {
  std::array<double, static_cast<std::size_t>(rows* columns)> entries{};

  constexpr double operator()(int i, int j = 0) const {
    return entries[static_cast<std::size_t>(i * columns + j)];
  }
  constexpr operator double() const
    requires(rows == 1 && columns == 1)
  {
    return entries[0];
  }
};

constexpr double constant_step(operation op, double a, double b) {
  namespace f = symbolic::elementary;
  switch (op) {
  case operation::negate: return -a;
  case operation::add: return a + b;
  case operation::subtract: return a - b;
  case operation::multiply: return a * b;
  case operation::divide: return a / b;
  case operation::power: return f::pow(a, b);
  case operation::sqrt: return f::sqrt(a);
  case operation::sin: return f::sin(a);
  case operation::cos: return f::cos(a);
  case operation::tan: return f::tan(a);
  case operation::asin: return f::asin(a);
  case operation::acos: return f::acos(a);
  case operation::atan: return f::atan(a);
  case operation::atan2: return f::atan2(a, b);
  case operation::exp: return f::exp(a);
  case operation::log: return f::log(a);
  case operation::abs: return f::abs(a);
  case operation::sign: return f::sign(a);
  default: return a;
  }
}

/// All slots of a tape, one after another; `value_of(load)` gives the arguments.
template <const auto& tape, class ValueOf>
constexpr auto constant_slots(ValueOf value_of) {
  std::array<double, static_cast<std::size_t>(tape.slots() + 1)> slot{};
  std::size_t next = 0;
  for (int i = 0; i < tape.sizes.numbers; ++i) slot[next++] = tape.numbers[i].value();
  for (int i = 0; i < tape.sizes.loads; ++i) slot[next++] = value_of(tape.loads[i]);
  for (int i = 0; i < tape.sizes.steps; ++i)
    slot[next++] = constant_step(tape.op[i], slot[static_cast<std::size_t>(tape.a[i])],
                                 slot[static_cast<std::size_t>(tape.b[i])]);
  return slot;
}

} // namespace kanexpr::lower
