#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic::detail {

/// Expressions as a network of sums of products.
///
/// A variable is a node, or a sum or a product that was taken out of others; these are numbered after the
/// nodes. A sum, a difference or a product has a definition unless it is merely a part of one other sum or
/// product. A definition is a list of terms, numbered from 1; a term is a sign and the product of its
/// factors, which are variables in ascending order. Code that runs often accesses the arrays directly,
/// because compilers interpret every call.
struct sums_of_products {
  // the templates precede their callers, because clang++ does not instantiate a template for a constant
  // expression if it is declared later in the class

  /// Lists the live nodes, users first, and counts how often each is used. In constant evaluation, this and
  /// the next function access the arrays themselves (base::zeros explains why).
  template <bool is_constant>
  constexpr void list_live(const sequence<int>& outputs, const sequence<int>& also_needed) {
    const auto& all = g.elements<is_constant>();
    auto &use = uses.elements<is_constant>(), &list = live.elements<is_constant>();
    int count = 0;
    for (int id : outputs) use[id] += 2; // an output is not merely a part
    for (int id = nodes - 1; id >= 0; --id) {
      if (use[id] == 0) continue;
      const operation op = all[id].op;
      if (op <= operation::symbol) continue;
      list[count++] = id;
      ++use[all[id].a];
      if (op <= operation::power ? op != operation::negate : is_binary(op) && is_value(all[id]))
        ++use[all[id].b];
    }
    live_count = count;
    if (also_needed.empty()) return;
    const base::zeros<char> needed = live_nodes(g, also_needed);
    for (int i = 0; i < count; ++i)
      if (list[i] < needed.size() && needed[list[i]] != 0) definition[list[i]] = kept;
  }

  /// Finds the terms of all sums and products.
  template <bool is_constant>
  constexpr void define() {
    const auto& all = g.elements<is_constant>();
    const auto &use = uses.elements<is_constant>(), &list = live.elements<is_constant>();
    auto &of = definition.elements<is_constant>(), &factor = factors.elements<is_constant>(),
         &from = begin.elements<is_constant>(), &by = owner_of.elements<is_constant>(),
         &count_of = seen.elements<is_constant>(), &first_of = first.elements<is_constant>(),
         &variable = variable_of.elements<is_constant>(), &last = last_term.elements<is_constant>();
    int d = 0, t = 1, f = 0;
    int pending[most_pending]{}, parts[most_pending]{};
    for (int i = 0, end = live_count; i < end; ++i) {
      const int root = list[i];
      const operation op = all[root].op;
      if ((op != operation::multiply && op != operation::add && op != operation::subtract) || of[root] != 0)
        continue;
      variable[d] = root;
      const int first_term = first_of[d] = t;
      ++d;
      int top = 1;
      pending[0] = 2 * root;
      while (top > 0) {
        const int id = pending[--top] / 2, sign = pending[top] % 2;
        const operation inner = all[id].op;
        const bool is_part = id == root || (use[id] == 1 && of[id] != kept && top + 2 < most_pending);
        if (is_part && inner <= operation::subtract && inner >= operation::negate) {
          of[id] = d;
          if (inner == operation::negate) {
            pending[top++] = 2 * all[id].a + 1 - sign;
          } else {
            pending[top++] = 2 * all[id].b + (inner == operation::subtract ? 1 - sign : sign);
            pending[top++] = 2 * all[id].a + sign;
          }
          continue;
        }
        int left = 0;
        if (is_part && inner == operation::multiply) {
          of[id] = d;
          parts[0] = all[id].b, parts[1] = all[id].a;
          left = 2;
        } else {
          parts[0] = id;
          left = 1;
        }
        const int start = f;
        bool may_be_seen_again = true;
        while (left > 0) {
          const int part = parts[--left];
          const int used = use[part];
          if (used == 1 && all[part].op == operation::multiply && of[part] != kept && part != id &&
              left + 2 < most_pending) {
            of[part] = d;
            parts[left++] = all[part].b, parts[left++] = all[part].a;
            continue;
          }
          int place = f++;
          for (; place > start && factor[place - 1] > part; --place) factor[place] = factor[place - 1];
          factor[place] = part;
          if (used < 2) {
            may_be_seen_again = false;
            continue; // seen once
          }
          ++count_of[part];
          if (const int before = last[part]; before >= first_term && before < t)
            has_common_factors[d - 1] = 1;
          last[part] = t;
        }
        by[t] = 2 * (d - 1) + sign;
        if (f - start > 2)
          long_terms.push(t);
        else if (may_be_seen_again)
          (f - start == 1 ? single_factors : pairs_of_factors).push(t);
        ++t;
        from[t] = f;
      }
    }
    first_of[d] = t;
    defined = definitions = d, terms = t, factor_count = f;
  }

  constexpr sums_of_products(graph& owner, const sequence<int>& outputs, const sequence<int>& also_needed)
      : g(owner), nodes(last_of(outputs) + 1), variables(nodes), room(4 * nodes + 1024), uses(nodes),
        definition(room), image(room), seen(room), live(nodes), variable_of(room), first(room), added(room),
        is_changed(room), has_common_factors(room), last_term(room), begin(room), owner_of(room), next(room),
        replacement(room), is_dropped(room), factors(room) {
    if (__builtin_is_constant_evaluated()) {
      list_live<true>(outputs, also_needed);
      define<true>();
    } else {
      list_live<false>(outputs, also_needed);
      define<false>();
    }
  }
  sums_of_products(const sums_of_products&) = delete;
  sums_of_products& operator=(const sums_of_products&) = delete;

  static constexpr int last_of(const sequence<int>& outputs) {
    int last = 0;
    for (int id : outputs)
      if (id > last) last = id;
    return last;
  }

  constexpr int size_of(int t) const { return begin[t + 1] - begin[t]; }

  /// The term that contains a factor, one of those that a definition had initially.
  constexpr int term_at(int factor, int d) const {
    int t = first[d];
    while (begin[t + 1] <= factor) ++t;
    return t;
  }

  // changes

  constexpr bool has_room_for(int more_factors) const {
    return factor_count + more_factors <= room && terms + 3 < room && variables + 1 < room;
  }
  constexpr void push_factor(int variable) { factors[factor_count++] = variable; }
  /// Ends a term whose factors were pushed. It takes the place of another one, unless that is 0.
  constexpr int end_term(int d, int sign, int instead_of) {
    const int t = terms++;
    begin[t + 1] = factor_count;
    for (int i = begin[t]; i < factor_count; ++i) ++seen[factors[i]];
    owner_of[t] = 2 * d + sign;
    if (instead_of != 0)
      replacement[instead_of] = t;
    else
      (added[d] == 0 ? added[d] : next[added[d]]) = t;
    is_changed[d] = 1;
    return t;
  }
  constexpr void drop_term(int t) {
    is_dropped[t] = 1;
    for (int i = begin[t]; i < begin[t + 1]; ++i) --seen[factors[i]];
  }
  /// Adds a variable; its terms are added to the definition that is returned.
  constexpr int take_out() {
    variable_of[definitions] = variables;
    definition[variables++] = definitions + 1;
    return definitions++;
  }
  /// The first term that a definition had, and the one that followed another; 0 if there is none.
  constexpr int first_of(int d) const { return d < defined ? first[d] : added[d]; }
  constexpr int next_of(int t, int d) const {
    if (d >= defined) return next[t];
    return t + 1 < first[d + 1] ? t + 1 : 0;
  }
  /// The term that is now at the place of another one; 0 if there is none.
  constexpr int now_at(int t) const {
    while (is_dropped[t] != 0) t = replacement[t];
    return t;
  }

  /// Builds the changed sums and products, and what depends on them.
  constexpr void rebuild() {
    const int *const list = live.begin(), *const of = definition.begin(), *const changed = is_changed.begin(),
                     *const variable = variable_of.begin();
    int* const images = image.begin();
    const node* all = g.begin();
    for (int i = live_count - 1; i >= 0; --i) {
      const int id = list[i], d = of[id] - 1;
      if (d >= 0 && changed[d] != 0) {
        if (variable[d] != id) continue;
        images[id] = built(d);
        all = g.begin();
        continue;
      }
      const node& n = all[id];
      const bool has_second =
          n.op <= operation::power ? n.op != operation::negate : is_binary(n.op) && is_value(n);
      const int a = images[n.a], b = has_second ? images[n.b] : 0;
      if (a == 0 && b == 0) continue;
      const int now = build(g, n.op, a != 0 ? a : n.a, b != 0 ? b : n.b);
      if (now != id) images[id] = now;
      all = g.begin();
    }
  }
  constexpr int image_of(int variable) {
    if (image[variable] != 0) return image[variable];
    if (variable < nodes) return variable;
    const int now = built(definition[variable] - 1);
    image[variable] = now;
    return now;
  }
  constexpr int built(int d) {
    int sum = graph::zero;
    for (int place = first_of(d); place != 0; place = next_of(place, d)) {
      const int t = now_at(place);
      if (t == 0) continue;
      int product = graph::one;
      for (int i = begin[t]; i < begin[t + 1]; ++i) product = multiply(g, product, image_of(factors[i]));
      sum = owner_of[t] % 2 != 0 ? subtract(g, sum, product) : add(g, sum, product);
    }
    return sum;
  }

  static constexpr int kept = -1; ///< the definition of a node that is needed in any case
  static constexpr int most_pending = 64;

  graph& g;
  int nodes, variables, room;
  int live_count = 0, defined = 0, definitions = 0, terms = 0, factor_count = 0;
  // by node
  base::zeros<int> uses;
  // by variable
  base::zeros<int> definition; ///< one more than its number
  base::zeros<int> image;      ///< 0 if it is the same
  base::zeros<int> seen;       ///< how often it is a factor
  base::zeros<int> live;       ///< the live nodes
  // by definition
  base::zeros<int> variable_of, first, added, is_changed, has_common_factors;
  base::zeros<int> last_term; ///< by variable, the last term that contains it
  // by term
  base::zeros<int> begin, owner_of, next, replacement, is_dropped;
  base::zeros<int> factors;
  // the terms of the definitions at first: those with three or more factors, and those with one or two of
  // which each may occur elsewhere
  sequence<int> long_terms{}, single_factors{}, pairs_of_factors{};
};

} // namespace kanexpr::symbolic::detail
