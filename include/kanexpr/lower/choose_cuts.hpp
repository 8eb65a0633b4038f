#pragma once

namespace kanexpr::lower {

/// In place of the number of live values: code must not be cut there.
inline constexpr int uncuttable = 1 << 30;

/// Cuts the code from `begin` to `end`, where `live[i]` values are live before line i, into pieces. Each cut
/// is where the fewest values are live among the lines at which the length of the piece differs from `length`
/// by at most a quarter; if none of them can be cut, it is at the first one thereafter. Calls `add(first)`
/// for each piece except the first one.
template <class Live, class Add>
constexpr void choose_cuts(const Live& live, int begin, int end, int length, const Add& add) {
  const int slack = length / 4;
  while (end - begin > length + slack) {
    const int last = begin + length + slack;
    int best = begin + length - slack;
    for (int i = best + 1; i < end && (i <= last || live[best] == uncuttable); ++i)
      if (live[i] < live[best]) best = i;
    if (live[best] == uncuttable) return;
    add(begin = best);
  }
}

} // namespace kanexpr::lower
