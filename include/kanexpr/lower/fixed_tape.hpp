#pragma once

#include <kanexpr/lower/tape.hpp>

namespace kanexpr::lower {

struct tape_sizes {
  int steps = 0;
  int numbers = 0;
  int loads = 0;
  int results = 0;
  int eliminations = 0;
  int operands = 0;
  int first_angle = 0;
  int angles = 0;
};

/// A tape that can leave a constant evaluation, as plain arrays; what is behind the sizes is unused.
template <tape_sizes room>
struct fixed_tape {
  static constexpr std::size_t at_least_one(int n) { return n > 0 ? static_cast<std::size_t>(n) : 1; }

  tape_sizes sizes;
  symbolic::cost cost;
  operation op[at_least_one(room.steps)]{};
  bool paired[at_least_one(room.steps)]{};
  int a[at_least_one(room.steps)]{};
  int b[at_least_one(room.steps)]{};
  symbolic::number numbers[at_least_one(room.numbers)]{};
  load loads[at_least_one(room.loads)]{};
  int results[at_least_one(room.results)]{};
  elimination eliminations[at_least_one(room.eliminations)]{};
  int operands[at_least_one(room.operands)]{};

  constexpr int first_step() const { return sizes.numbers + sizes.loads; }
  constexpr int slot_count() const { return first_step() + sizes.steps; }
};

/// Room for any model that a compiler can be asked to derive. It costs nothing as long as only constant
/// evaluation sees it: `trimmed` makes the tape that programs use.
inline constexpr int most_steps = 1 << 16;
inline constexpr tape_sizes room_of_tape{most_steps,      most_steps, most_steps, most_steps,
                                         most_steps / 16, most_steps, 0,          0};
using roomy_tape = fixed_tape<room_of_tape>;

constexpr tape_sizes sizes_of(const tape& t) {
  return {t.steps.size(),        t.numbers.size(),  t.loads.size(), t.results.size(),
          t.eliminations.size(), t.operands.size(), t.first_angle,  t.angle_count};
}

constexpr bool has_room_for(const tape_sizes& s) {
  return s.steps <= room_of_tape.steps && s.numbers <= room_of_tape.numbers &&
         s.loads <= room_of_tape.loads && s.results <= room_of_tape.results &&
         s.eliminations <= room_of_tape.eliminations && s.operands <= room_of_tape.operands;
}

namespace detail {

template <class To, class From>
constexpr void copy_lists(To& to, const From& from) {
  for (int i = 0; i < to.sizes.numbers; ++i) to.numbers[i] = from.numbers[i];
  for (int i = 0; i < to.sizes.loads; ++i) to.loads[i] = from.loads[i];
  for (int i = 0; i < to.sizes.results; ++i) to.results[i] = from.results[i];
  for (int i = 0; i < to.sizes.eliminations; ++i) to.eliminations[i] = from.eliminations[i];
  for (int i = 0; i < to.sizes.operands; ++i) to.operands[i] = from.operands[i];
}

} // namespace detail

/// Only of a tape that there is room for.
constexpr roomy_tape fixed(const tape& t) {
  roomy_tape out{};
  out.sizes = sizes_of(t);
  out.cost = cost_of(t);
  for (int i = 0; i < out.sizes.steps; ++i) {
    out.op[i] = t.steps[i].op;
    out.paired[i] = t.steps[i].paired;
    out.a[i] = t.steps[i].a;
    out.b[i] = t.steps[i].b;
  }
  detail::copy_lists(out, t);
  return out;
}

/// The same in arrays of its own sizes, `trimmed<roomy.sizes>(roomy)`.
template <tape_sizes sizes>
constexpr fixed_tape<sizes> trimmed(const roomy_tape& from) {
  fixed_tape<sizes> out{};
  out.sizes = sizes;
  out.cost = from.cost;
  for (int i = 0; i < sizes.steps; ++i) {
    out.op[i] = from.op[i];
    out.paired[i] = from.paired[i];
    out.a[i] = from.a[i];
    out.b[i] = from.b[i];
  }
  detail::copy_lists(out, from);
  return out;
}

} // namespace kanexpr::lower
