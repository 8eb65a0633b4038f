#pragma once

#include <kanexpr/lower/tape.hpp>

namespace kanexpr::lower {

struct tape_sizes {
  int steps = 0;
  int numbers = 0;
  int loads = 0;
  int results = 0;
  int first_angle = 0;
  int angles = 0;
  int eliminations = 0;
};

/// A tape that can leave a constant evaluation, as plain arrays; what is behind the sizes is unused.
template <int step_room, int number_room, int load_room, int result_room, int elimination_room>
struct fixed_tape {
  tape_sizes sizes;
  symbolic::cost cost;
  operation op[step_room]{};
  bool paired[step_room]{};
  int a[step_room]{};
  int b[step_room]{};
  symbolic::number numbers[number_room]{};
  load loads[load_room]{};
  int results[result_room]{};
  elimination eliminations[elimination_room]{};
  int operands[step_room]{};

  constexpr int first_step() const { return sizes.numbers + sizes.loads; }
  constexpr int slots() const { return first_step() + sizes.steps; }
};

/// Room for any model that a compiler can be asked to derive. Unused room costs nothing.
inline constexpr int roomy = 1 << 16;
using roomy_tape = fixed_tape<roomy, roomy, roomy, roomy, roomy / 16>;

constexpr roomy_tape fixed(const tape& t) {
  roomy_tape out{};
  out.sizes = {t.steps.size(), t.numbers.size(), t.loads.size(),       t.results.size(),
               t.first_angle,  t.angle_count,    t.eliminations.size()};
  out.cost = cost_of(t);
  for (int i = 0; i < t.steps.size(); ++i) {
    out.op[i] = t.steps[i].op;
    out.paired[i] = t.steps[i].paired;
    out.a[i] = t.steps[i].a;
    out.b[i] = t.steps[i].b;
  }
  for (int i = 0; i < t.numbers.size(); ++i) out.numbers[i] = t.numbers[i];
  for (int i = 0; i < t.loads.size(); ++i) out.loads[i] = t.loads[i];
  for (int i = 0; i < t.results.size(); ++i) out.results[i] = t.results[i];
  for (int i = 0; i < t.eliminations.size(); ++i) out.eliminations[i] = t.eliminations[i];
  for (int i = 0; i < t.operands.size(); ++i) out.operands[i] = t.operands[i];
  return out;
}

} // namespace kanexpr::lower
