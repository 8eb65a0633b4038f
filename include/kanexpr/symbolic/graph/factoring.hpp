#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/sums_of_products.hpp>

namespace kanexpr::symbolic {

/// Takes out of sums and products what they have in common.
///
/// A kernel is a sum of two terms a + b that occurs, times a product of other factors, in one or more sums:
/// a x + b x = (a + b) x. Of all kernels and all pairs of factors, the one that saves most operations is
/// taken out first (Rajski & Vasudevamurthi, The testability-preserving concurrent decomposition and
/// factorization of Boolean expressions, IEEE Trans. CAD 11, 1992; for polynomials: Hosangadi, Fallah &
/// Kastner, Optimizing polynomial expressions by algebraic factorization and common subexpression
/// elimination, IEEE Trans. CAD 25, 2006).
class factoring {
public:
  constexpr factoring(graph& g, const sequence<int>& outputs, const sequence<int>& also_needed)
      : outputs_(outputs), s_(g, outputs, also_needed), last_(s_.room), before_(s_.room), table_(table_room),
        first_(most_pairs), second_(most_pairs), occurrences_(most_pairs), most_(most_pairs),
        term_a_(most_pairs), term_b_(most_pairs), next_occurrence_(most_pairs) {}
  factoring(const factoring&) = delete;
  factoring& operator=(const factoring&) = delete;

  /// Whether anything was taken out.
  constexpr bool run() {
    list_pairs_of_factors();
    list_pairs_of_terms();
    const int* const has_common_factors = s_.has_common_factors.begin();
    for (int d = 0, end = s_.defined; d < end; ++d)
      if (has_common_factors[d] != 0) compare_terms(d);
    while (take_out_best()) {
    }
    if (saved_ == 0) return false;
    s_.rebuild();
    return true;
  }
  constexpr sequence<int> images() {
    sequence<int> found;
    for (int id : outputs_) found.push(s_.image_of(id));
    return found;
  }
  /// The operations saved, and those before.
  constexpr int saved() const { return saved_; }
  constexpr int operations() const { return s_.live_count; }

private:
  static constexpr int none = -1;
  static constexpr int table_room = 1 << 16, most_pairs = table_room / 2;
  static constexpr int most_gain = 24, most_singles = 32;
  enum kind { sum, difference, product, prefix };

  /// Lists the pairs of factors that terms have in common. Two terms with only two factors are never equal,
  /// because equal nodes are one.
  constexpr void list_pairs_of_factors() {
    for (int t : s_.long_terms) pair_factors(t);
    if (pairs_ == 1) return;
    const int *const begin = s_.begin.begin(), *const factor = s_.factors.begin(),
                     *const seen = s_.seen.begin();
    for (int t : s_.pairs_of_factors) {
      const int a = factor[begin[t]], b = factor[begin[t] + 1];
      if (seen[a] > 1 && seen[b] > 1 && found(a, b, product) != 0) note(a, b, product, t, t);
    }
  }
  constexpr void pair_factors(int t) {
    const int *const factor = s_.factors.begin(), *const seen = s_.seen.begin();
    const int from = s_.begin[t], to = s_.begin[t + 1];
    for (int i = from; i < to; ++i) {
      if (seen[factor[i]] < 2 || (i > from && factor[i - 1] == factor[i])) continue;
      for (int j = i + 1; j < to; ++j)
        if (seen[factor[j]] > 1 && (j == i + 1 || factor[j - 1] != factor[j]))
          note(factor[i], factor[j], product, t, t);
    }
  }

  /// Lists the pairs of single variables in one sum, which other sums may share.
  constexpr void list_pairs_of_terms() {
    const int *const begin = s_.begin.begin(), *const factor = s_.factors.begin(),
                     *const seen = s_.seen.begin(), *const owner = s_.owner_of.begin();
    int singles[most_singles]{}, count = 0, d = none;
    for (int t : s_.single_factors) {
      const int f = factor[begin[t]];
      if (seen[f] < 2) continue;
      if (owner[t] / 2 != d) d = owner[t] / 2, count = 0;
      for (int k = 0; k < count; ++k) note_terms(singles[k], t, factor[begin[singles[k]]] + 1, f + 1, false);
      if (count < most_singles) singles[count++] = t;
    }
  }
  /// Lists the pairs of terms of one sum that share a factor.
  constexpr void compare_terms(int d) {
    const int *const begin = s_.begin.begin(), *const factor = s_.factors.begin();
    int *const last = last_.begin(), *const before = before_.begin();
    const int first = s_.first[d], end = s_.first[d + 1], start = begin[first];
    for (int t = first; t < end; ++t) {
      const int from = begin[t], to = begin[t + 1];
      for (int i = from; i < to; ++i) {
        const int f = factor[i], same = before[i] = last[f];
        last[f] = i + 1;
        for (int l = same; l > start; l = before[l - 1])
          if (l <= from) pair_terms(s_.term_at(l - 1, d), t, f);
      }
    }
  }

  /// Compares two terms whose first common factor is `common`.
  constexpr void pair_terms(int s, int t, int common) {
    const int* const factors = s_.factors.begin();
    int i = s_.begin[s], j = s_.begin[t], a = 0, b = 0;
    const int to_i = s_.begin[s + 1], to_j = s_.begin[t + 1];
    bool has_common = false;
    if (pairs_ + to_i - i + to_j - j > most_pairs) return;
    while (i < to_i || j < to_j) {
      const int x = i < to_i ? factors[i] : s_.room, y = j < to_j ? factors[j] : s_.room;
      if (x == y) {
        if (!has_common && x != common) return; // compared because of the other factor
        has_common = true;
        ++i, ++j;
      } else if (x < y) {
        a = a == 0 ? x + 1 : find_or_add(a, x, prefix) + s_.room + 1;
        ++i;
      } else {
        b = b == 0 ? y + 1 : find_or_add(b, y, prefix) + s_.room + 1;
        ++j;
      }
    }
    if (a != b) note_terms(s, t, a, b, true);
  }
  constexpr void note_terms(int s, int t, int a, int b, bool has_base) {
    const kind which = (s_.owner_of[s] - s_.owner_of[t]) % 2 == 0 ? sum : difference;
    if (a < b)
      note(a, b, which, s, t, has_base);
    else
      note(b, a, which, t, s, has_base);
  }

  /// The number of a pair, or 0: of two sets of factors in a sum or difference, two factors, or a set of
  /// factors and a further one. A set is 0 if it is empty, one more than the only factor, or the number of a
  /// pair plus `room` + 1.
  constexpr int found(int a, int b, kind which) const {
    constexpr unsigned mask = table_room - 1;
    const int second = 4 * b + which;
    const int* const table = table_.begin();
    const int *const first_of = first_.begin(), *const second_of = second_.begin();
    unsigned place = static_cast<unsigned>(a * 31 + second * 7) & mask;
    for (int found = table[place]; found != 0; found = table[place = (place + 1) & mask])
      if (first_of[found] == a && second_of[found] == second) return found;
    return 0;
  }
  constexpr int find_or_add(int a, int b, kind which) {
    constexpr unsigned mask = table_room - 1;
    const int second = 4 * b + which;
    int *const table = table_.begin(), *const first_of = first_.begin(), *const second_of = second_.begin();
    unsigned place = static_cast<unsigned>(a * 31 + second * 7) & mask;
    for (int found = table[place]; found != 0; found = table[place = (place + 1) & mask])
      if (first_of[found] == a && second_of[found] == second) return found;
    first_of[pairs_] = a, second_of[pairs_] = second;
    return table[place] = pairs_++;
  }

  constexpr void note(int a, int b, kind which, int s, int t, bool has_base = false) {
    if (pairs_ == most_pairs || noted_ == most_pairs) return;
    const int d = find_or_add(a, b, which), before = occurrences_.begin()[d], o = noted_++;
    occurrences_.begin()[d] = o;
    term_a_.begin()[o] = s, term_b_.begin()[o] = t, next_occurrence_.begin()[o] = before;
    if (before == 0 && !has_base) return;
    const int gain = gain_of(d);
    if (gain > most_[d]) file(d, gain);
  }
  constexpr void file(int d, int gain) {
    most_[d] = gain < most_gain ? gain : most_gain;
    filed_[most_[d]].push(d);
  }

  constexpr int length(int set) const {
    int n = 0;
    for (; set > s_.room; set = first_[set - s_.room - 1]) ++n;
    return set == 0 ? n : n + 1;
  }

  /// The number of operations that taking out a pair saves.
  constexpr int gain_of(int d) {
    const kind which = static_cast<kind>(second_[d] % 4);
    const int *const dropped = s_.is_dropped.begin(), *const a = term_a_.begin(), *const b = term_b_.begin(),
                     *const next = next_occurrence_.begin();
    if (which == product) {
      int gain = -1;
      for (int o = occurrences_[d]; o != 0; o = next[o]) gain += 1 - dropped[a[o]];
      return gain;
    }
    const int first = length(first_[d]), second = length(second_[d] / 4);
    int gain = -1 - (first > 1 ? first - 1 : 0) - (second > 1 ? second - 1 : 0);
    for (int o = occurrences_[d]; o != 0; o = next[o]) {
      if (dropped[a[o]] != 0 || dropped[b[o]] != 0 || is_before(o, d)) continue;
      const int base = s_.size_of(a[o]) - first;
      gain += first + second + base - 1;
      if (base == 0) gain += (first == 0 ? 1 : 0) + (second == 0 ? 1 : 0);
    }
    return gain;
  }
  /// Whether an occurrence shares a term with one that precedes it in the list.
  constexpr bool is_before(int o, int d) const {
    for (int other = occurrences_[d]; other != o; other = next_occurrence_[other]) {
      const int s = term_a_[other], t = term_b_[other];
      if ((s == term_a_[o] || s == term_b_[o] || t == term_a_[o] || t == term_b_[o]) &&
          s_.is_dropped[s] == 0 && s_.is_dropped[t] == 0)
        return true;
    }
    return false;
  }

  constexpr bool take_out_best() {
    for (int gain = most_gain; gain > 0; --gain)
      while (!filed_[gain].empty()) {
        const int d = filed_[gain].back();
        filed_[gain].pop();
        if (most_[d] != gain) continue;
        const int now = gain_of(d);
        most_[d] = 0;
        if (now < gain) {
          if (now > 0) file(d, now);
          continue;
        }
        if (!take_out(d)) return false;
        saved_ += now;
        return true;
      }
    return false;
  }

  /// Appends the factors of a set in ascending order.
  constexpr void push_factors(int set) {
    if (set > s_.room) {
      push_factors(first_[set - s_.room - 1]);
      s_.push_factor(second_[set - s_.room - 1] / 4);
    } else if (set != 0) {
      s_.push_factor(set - 1);
    }
  }

  constexpr bool take_out(int d) {
    const kind which = static_cast<kind>(second_[d] % 4);
    const int first = first_[d], second = second_[d] / 4;
    if (!s_.has_room_for(which == product ? 2 : length(first) + length(second) + 2)) return false;
    const int v = s_.variables, own = s_.take_out();
    sequence<int> added;
    if (which == product) {
      s_.push_factor(first), s_.push_factor(second);
      added.push(s_.end_term(own, 0, 0));
    } else {
      push_factors(first);
      added.push(s_.end_term(own, 0, 0));
      push_factors(second);
      added.push(s_.end_term(own, which == difference ? 1 : 0, 0));
    }
    int o = occurrences_[d];
    occurrences_[d] = 0;
    for (; o != 0; o = next_occurrence_[o]) {
      const int s = term_a_[o], t = term_b_[o];
      if (s_.is_dropped[s] != 0 || s_.is_dropped[t] != 0 || !s_.has_room_for(s_.size_of(s) + 1)) continue;
      push_without(s, added[0]);
      s_.push_factor(v);
      s_.drop_term(s);
      if (t != s) s_.drop_term(t);
      added.push(s_.end_term(s_.owner_of[s] / 2, s_.owner_of[s] % 2, s < t ? s : t));
    }
    for (int t : added) compare_with_others(t);
    return true;
  }
  /// Appends the factors of a term except those of another one.
  constexpr void push_without(int t, int other) {
    int k = s_.begin[other];
    for (int i = s_.begin[t], end = s_.begin[t + 1]; i < end; ++i) {
      const int f = s_.factors[i];
      if (k < s_.begin[other + 1] && s_.factors[k] == f)
        ++k;
      else
        s_.push_factor(f);
    }
  }
  constexpr void compare_with_others(int t) {
    pair_factors(t);
    const int *const begin = s_.begin.begin(), *const factor = s_.factors.begin(),
                     *const seen = s_.seen.begin(), *const dropped = s_.is_dropped.begin();
    const int d = s_.owner_of[t] / 2, from = begin[t], to = begin[t + 1], own = factor[from];
    for (int place = s_.first_of(d); place != 0; place = s_.next_of(place, d)) {
      const int s = dropped[place] != 0 ? s_.now_at(place) : place;
      if (s == 0 || s >= t) continue;
      int i = begin[s], j = from;
      const int end = begin[s + 1];
      if (to - from == 1 && end - i == 1) {
        if (factor[i] != own && seen[factor[i]] > 1) note_terms(s, t, factor[i] + 1, own + 1, false);
        continue;
      }
      while (i < end && j < to && factor[i] != factor[j]) ++(factor[i] < factor[j] ? i : j);
      if (i < end && j < to) pair_terms(s, t, factor[i]);
    }
  }

  const sequence<int>& outputs_;
  detail::sums_of_products s_;
  base::zeros<int> last_;   ///< by variable, one more than the last place at which it is a factor
  base::zeros<int> before_; ///< by place of a factor, one more than the place before with the same factor
  base::zeros<int> table_;  ///< open addressing: the number of a pair; 0 marks a free slot
  base::zeros<int> first_, second_, occurrences_, most_; // by pair
  base::zeros<int> term_a_, term_b_, next_occurrence_;   // by occurrence of a pair
  int pairs_ = 1, noted_ = 1;
  sequence<int> filed_[most_gain + 1]{}; ///< the pairs by the number of operations that they may save
  int saved_ = 0;
};

/// Returns the outputs with common parts of sums and products taken out. The nodes in `also_needed` are
/// needed regardless of the outputs and remain unchanged. Long outputs are returned unchanged, because the
/// time that compilers take for them matters more.
constexpr sequence<int> factored(graph& g, const sequence<int>& outputs, const sequence<int>& also_needed,
                                 int most_operations = 2500, int most_passes = 4) {
  constexpr int least_part = 128; // what saves less is not worth another pass
  sequence<int> now = outputs;
  for (int pass = 0; pass < most_passes; ++pass) {
    factoring sums(g, now, also_needed);
    if (sums.operations() > most_operations || !sums.run()) break;
    now = sums.images();
    if (sums.saved() * least_part < sums.operations()) break;
  }
  return now;
}

/// The same for the entries of a matrix, where those of another one are needed in any case.
constexpr matrix factored(graph& g, matrix m, const matrix& also_needed, int most_operations,
                          int most_passes) {
  const sequence<int> outputs = nodes_of(m.entries), needed = nodes_of(also_needed.entries);
  m.entries = expressions_of(g, factored(g, outputs, needed, most_operations, most_passes));
  return m;
}

} // namespace kanexpr::symbolic
