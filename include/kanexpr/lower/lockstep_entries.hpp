#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::lower {

using base::sequence;
using symbolic::operation;

/// How an operand is read: one lane of a vector, a scalar, or all lanes; a scalar is the same in all lanes.
struct operand_form {
  int lane = scalar;
  bool is_minus = false;

  static constexpr int scalar = 4, whole = 5;
};

/// What fills an entry, encoded as a number, so that all entries with the same action share one function.
struct lockstep_action {
  enum class kind { argument, value, vector, gather };

  kind is = kind::argument;
  operation op = operation::constant; ///< a change of sign denotes a value that is only stored
  operand_form a{}, b{};
  int minus_a = 0, minus_b = 0; ///< of a vector: the lanes in which an operand changes its sign
  bool is_kept = false;         ///< whether the value is stored in memory

  constexpr int code() const {
    const int forms = a.lane + 8 * b.lane + 64 * (a.is_minus ? 1 : 0) + 128 * (b.is_minus ? 1 : 0);
    return static_cast<int>(is) + 4 * (static_cast<int>(op) + 64 * (forms + 256 * (minus_a + 16 * minus_b))) +
           (is_kept ? 1 << 28 : 0);
  }
  static constexpr lockstep_action of(int code) {
    const auto next = [&](int values) {
      const int value = code % values;
      code /= values;
      return value;
    };
    lockstep_action read;
    read.is = static_cast<kind>(next(4));
    read.op = static_cast<operation>(next(64));
    read.a.lane = next(8), read.b.lane = next(8);
    read.a.is_minus = next(2) != 0, read.b.is_minus = next(2) != 0;
    read.minus_a = next(16), read.minus_b = next(16);
    read.is_kept = code != 0;
    return read;
  }
};

/// The entries of a function that evaluates bundles of steps in lockstep and the other steps one by one. The
/// numbers, the early arguments, the first steps and the angles precede them.
struct lockstep_entries {
  sequence<int> early{};                     ///< the arguments that the first steps need
  int count = 0;                             ///< of entries
  base::zeros<int> action, place;            ///< of each entry; places in memory
  base::zeros<int> a, b, c, d;               ///< the entries of the operands; a gathered vector has four
  int operations = 0, vector_operations = 0; ///< how many entries are operations, and how many of all lanes

  constexpr explicit lockstep_entries(int most)
      : action(most), place(most), a(most), b(most), c(most), d(most) {}
};

} // namespace kanexpr::lower
