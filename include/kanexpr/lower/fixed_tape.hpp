#pragma once

#include <kanexpr/lower/tape.hpp>
#include <kanexpr/lower/tape_cost.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::lower {

struct tape_sizes {
  int steps = 0;
  int numbers = 0;
  int loads = 0;
  int results = 0;
  int linear_steps = 0;
  int operands = 0;
  int externals = 0;
  int first_angle = 0;
  int angles = 0;
};

/// A tape that can outlive constant evaluation: plain arrays of exact size.
template <tape_sizes own>
struct fixed_tape {
  static constexpr std::size_t at_least_one(int n) { return n > 0 ? static_cast<std::size_t>(n) : 1; }

  tape_sizes sizes;
  symbolic::cost cost;
  operation op[at_least_one(own.steps)]{};
  bool paired[at_least_one(own.steps)]{};
  int a[at_least_one(own.steps)]{};
  int b[at_least_one(own.steps)]{};
  symbolic::number numbers[at_least_one(own.numbers)]{};
  load loads[at_least_one(own.loads)]{};
  int results[at_least_one(own.results)]{};
  linear_step linear_steps[at_least_one(own.linear_steps)]{};
  int operands[at_least_one(own.operands)]{};
  const symbolic::external_function* externals[at_least_one(own.externals)]{};

  constexpr int first_step() const { return sizes.numbers + sizes.loads; }
  constexpr int slot_count() const { return first_step() + sizes.steps; }
};

/// Enough capacity for any model that a compiler can derive in reasonable time.
inline constexpr int most_steps = 1 << 17;
inline constexpr int most_linear_steps = most_steps / 16;
inline constexpr int most_externals = 1 << 8;

/// A tape of that capacity; entries beyond the sizes are unused. It costs nothing if only constant evaluation
/// uses it; programs use the tape that `trimmed` returns.
///
/// All entries are scalars, because clang++ creates every element of an array of classes with member
/// initializers, but only those elements of an array of scalars that are written.
struct roomy_tape {
  tape_sizes sizes{};
  symbolic::cost cost{};
  operation op[most_steps]{};
  bool paired[most_steps]{};
  int a[most_steps]{};
  int b[most_steps]{};
  std::int64_t numerators[most_steps]{};
  std::int64_t denominators[most_steps]{};
  double reals[most_steps]{};
  symbolic::symbol_kind loaded_from[most_steps]{};
  int loaded_position[most_steps]{};
  int results[most_steps]{};
  operation linear_operations[most_linear_steps]{};
  int orders[most_linear_steps]{};
  int linear_step_slots[most_linear_steps]{};
  int factors[most_linear_steps]{};
  int first_operands[most_linear_steps]{};
  int operands[most_steps]{};
  const symbolic::external_function* externals[most_externals]{};
};

template <class Steps>
constexpr tape_sizes sizes_of(const basic_tape<Steps>& t) {
  return {t.steps.size(),    t.numbers.size(),   t.loads.size(), t.results.size(), t.linear_steps.size(),
          t.operands.size(), t.externals.size(), t.first_angle,  t.angle_count};
}

constexpr bool has_room_for(const tape_sizes& s) {
  return s.steps <= most_steps && s.numbers <= most_steps && s.loads <= most_steps &&
         s.results <= most_steps && s.linear_steps <= most_linear_steps && s.operands <= most_steps &&
         s.externals <= most_externals;
}

/// Copies a tape, which must not exceed the capacity.
template <class Steps>
constexpr roomy_tape fixed(const basic_tape<Steps>& t) {
  roomy_tape out{};
  out.sizes = sizes_of(t);
  out.cost = cost_of(t);
  if constexpr (requires { t.steps.count; }) {
    const auto& op = t.steps.op.template elements<true>();
    const auto& paired = t.steps.paired.template elements<true>();
    const auto &a = t.steps.a.template elements<true>(), &b = t.steps.b.template elements<true>();
    auto& to_op = out.op;
    auto& to_paired = out.paired;
    auto &to_a = out.a, &to_b = out.b;
    for (int i = 0, steps = t.steps.size(); i < steps; ++i) {
      to_op[i] = op[i];
      if (paired[i] != 0) to_paired[i] = true;
      to_a[i] = a[i];
      to_b[i] = b[i];
    }
  } else {
    for (int i = 0; i < out.sizes.steps; ++i) {
      const instruction& step = t.steps[i];
      out.op[i] = step.op;
      out.paired[i] = step.paired;
      out.a[i] = step.a;
      out.b[i] = step.b;
    }
  }
  for (int i = 0; i < out.sizes.numbers; ++i) {
    out.numerators[i] = t.numbers[i].numerator;
    out.denominators[i] = t.numbers[i].denominator;
    out.reals[i] = t.numbers[i].real;
  }
  for (int i = 0; i < out.sizes.loads; ++i) {
    out.loaded_from[i] = t.loads[i].from;
    out.loaded_position[i] = t.loads[i].position;
  }
  for (int i = 0; i < out.sizes.results; ++i) out.results[i] = t.results[i];
  for (int i = 0; i < out.sizes.linear_steps; ++i) {
    out.linear_operations[i] = t.linear_steps[i].op;
    out.orders[i] = t.linear_steps[i].order;
    out.linear_step_slots[i] = t.linear_steps[i].step;
    out.factors[i] = t.linear_steps[i].factors;
    out.first_operands[i] = t.linear_steps[i].operands;
  }
  for (int i = 0; i < out.sizes.operands; ++i) out.operands[i] = t.operands[i];
  for (int i = 0; i < out.sizes.externals; ++i) out.externals[i] = t.externals[i];
  return out;
}

/// Converts a tape to arrays of exact size: `trimmed<roomy.sizes>(roomy)`.
template <tape_sizes sizes>
constexpr fixed_tape<sizes> trimmed(const roomy_tape& from) {
  fixed_tape<sizes> out{};
  out.sizes = sizes;
  out.cost = from.cost;
  const auto& op = from.op; // references to arrays, because compilers remember every address
  const auto& paired = from.paired;
  const auto &a = from.a, &b = from.b;
  auto& to_op = out.op;
  auto& to_paired = out.paired;
  auto &to_a = out.a, &to_b = out.b;
  for (int i = 0; i < sizes.steps; ++i) {
    to_op[i] = op[i];
    to_paired[i] = paired[i];
    to_a[i] = a[i];
    to_b[i] = b[i];
  }
  for (int i = 0; i < sizes.numbers; ++i)
    out.numbers[i] = {from.numerators[i], from.denominators[i], from.reals[i]};
  for (int i = 0; i < sizes.loads; ++i) out.loads[i] = {from.loaded_from[i], from.loaded_position[i]};
  for (int i = 0; i < sizes.results; ++i) out.results[i] = from.results[i];
  for (int i = 0; i < sizes.linear_steps; ++i)
    out.linear_steps[i] = {from.linear_operations[i], from.orders[i], from.linear_step_slots[i],
                           from.factors[i], from.first_operands[i]};
  for (int i = 0; i < sizes.operands; ++i) out.operands[i] = from.operands[i];
  for (int i = 0; i < sizes.externals; ++i) out.externals[i] = from.externals[i];
  return out;
}

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
