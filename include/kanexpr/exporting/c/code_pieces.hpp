#pragma once

#include <kanexpr/lower/choose_cuts.hpp>
#include <kanexpr/lower/statements.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kanexpr::exporting {

/// The lengths of functions, in lines of code.
struct function_lengths {
  int longest = 30000; ///< of a function that is not divided into pieces
  int piece = 1500;
};

/// The pieces of a long function, because the time that compilers need grows faster than the length of a
/// function, and the values that one piece computes and others, or the results, need. These values have
/// places in memory; the pieces read arguments and numbers again.
class code_pieces {
public:
  static constexpr int none = -1;

  code_pieces(const lower::statements& code, const function_lengths& allowed)
      : code_(code), place_(static_cast<std::size_t>(code.lines.size()), none) {
    const int lines = code.lines.size();
    if (lines <= allowed.longest) return;
    find_last_uses();
    count_live_values();
    first_ = {0};
    lower::choose_cuts(live_.data(), 0, lines, (std::min)(allowed.piece, lines),
                       [&](int line) { first_.push_back(line); });
    first_.push_back(lines);
    assign_places();
  }

  /// Zero for a function that is not divided.
  int count() const { return static_cast<int>(first_.size()) - 1; }
  int begin(int piece) const { return first_[static_cast<std::size_t>(piece)]; }
  int end(int piece) const { return first_[static_cast<std::size_t>(piece) + 1]; }
  /// The place of the value of a line, or none.
  int place(int line) const { return place_[static_cast<std::size_t>(line)]; }
  int places() const { return places_; }

private:
  using kind = lower::statement::kind;
  using operation = symbolic::operation;

  static bool is_computed(const lower::statement& s) {
    return s.is != kind::number && s.is != kind::argument;
  }

  void find_last_uses() {
    last_use_.assign(place_.size(), none);
    for (int i = 0; i < code_.lines.size(); ++i)
      lower::for_each_operand(code_, code_.lines[i], [&](int place) { last_use(place) = i; });
    for (int result : code_.results) last_use(result) = code_.lines.size();
  }
  int& last_use(int line) { return last_use_[static_cast<std::size_t>(line)]; }

  /// Counts the values that lines before each line compute and later ones read. A piece must not begin
  /// between a sine and its cosine, nor between a product and its sum, which compilers can fuse.
  void count_live_values() {
    const int lines = code_.lines.size();
    live_.assign(static_cast<std::size_t>(lines) + 2, 0);
    for (int i = 0; i < lines; ++i) {
      if (!is_computed(code_.lines[i]) || last_use(i) <= i) continue;
      ++live(i + 1);
      if (last_use(i) < lines) --live(last_use(i) + 1);
    }
    for (int i = 1; i <= lines; ++i) live(i) += live(i - 1);
    for (int i = 0; i < lines; ++i) {
      const lower::statement& s = code_.lines[i];
      if (s.is == kind::entry) live(i) = lower::uncuttable;
      if (s.is != kind::operation) continue;
      if (s.op == operation::multiply && last_use(i) <= i + 2)
        for (int line = i + 1; line <= last_use(i) && line < lines; ++line) live(line) = lower::uncuttable;
      if (s.op == operation::cos) live(i) = lower::uncuttable;
    }
  }
  int& live(int line) { return live_[static_cast<std::size_t>(line)]; }

  /// A place is used again only by pieces that follow the last one that reads it.
  void assign_places() {
    std::vector<std::vector<int>> released(static_cast<std::size_t>(count()) + 1);
    std::vector<int> unused;
    for (int piece = 0; piece < count(); ++piece) {
      for (int i = begin(piece); i < end(piece); ++i) {
        if (!is_computed(code_.lines[i]) || last_use(i) < end(piece)) continue;
        int reader = piece + 1;
        while (reader < count() && end(reader) <= last_use(i)) ++reader;
        int own = places_;
        if (unused.empty()) {
          ++places_;
        } else {
          own = unused.back();
          unused.pop_back();
        }
        place_[static_cast<std::size_t>(i)] = own;
        released[static_cast<std::size_t>(reader)].push_back(own);
      }
      const std::vector<int>& after = released[static_cast<std::size_t>(piece)];
      unused.insert(unused.end(), after.begin(), after.end());
    }
  }

  const lower::statements& code_;
  std::vector<int> first_{0}; ///< the first line of each piece, followed by the number of lines
  std::vector<int> place_;
  std::vector<int> last_use_{}; ///< the line that reads each value last; the number of lines for a result
  std::vector<int> live_{};
  int places_ = 0;
};

} // namespace kanexpr::exporting
