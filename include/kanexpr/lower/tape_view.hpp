#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/symbolic/graph/external.hpp>

namespace kanexpr::lower {

/// A view of a contiguous array.
template <class Number>
class view {
public:
  constexpr view(const Number* first, int size) : first_(first), size_(size) {}
  constexpr int size() const { return size_; }
  constexpr const Number& operator[](int i) const { return first_[i]; }
  constexpr const Number* begin() const { return first_; }
  constexpr const Number* end() const { return first_ + size_; }

private:
  const Number* first_;
  int size_;
};

/// The steps of a fixed tape.
struct steps_view {
  const operation* op;
  const bool* paired;
  const int *a, *b;
  int count;

  constexpr int size() const { return count; }
  constexpr instruction operator[](int i) const { return {op[i], a[i], b[i], paired[i]}; }
};

/// A view of a fixed tape of any size, with the members of `tape`, for functions that should not be compiled
/// separately for each tape.
struct tape_view {
  steps_view steps;
  view<symbolic::number> numbers;
  view<load> loads;
  view<int> results;
  view<linear_step> linear_steps;
  view<int> operands;
  view<const symbolic::external_function*> externals;

  template <tape_sizes own>
  constexpr explicit tape_view(const fixed_tape<own>& of)
      : steps{of.op, of.paired, of.a, of.b, own.steps}, numbers(of.numbers, own.numbers),
        loads(of.loads, own.loads), results(of.results, own.results),
        linear_steps(of.linear_steps, own.linear_steps), operands(of.operands, own.operands),
        externals(of.externals, own.externals) {}

  constexpr int first_step() const { return numbers.size() + loads.size(); }
  constexpr int slot_count() const { return first_step() + steps.size(); }
};

} // namespace kanexpr::lower
