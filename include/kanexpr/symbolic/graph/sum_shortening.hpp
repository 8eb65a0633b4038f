#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/combinable_angles.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/monomials.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Shortens sums in which sin² + cos² of an angle occurs or terms cancel after their products are multiplied
/// out.
namespace kanexpr::symbolic {

/// Rewrites such sums in the outputs. The nodes in `also_needed` are needed regardless of the outputs.
class sum_shortening {
public:
  /// The sums to rewrite: either those that individually reduce the number of operations of all outputs
  /// together (as in logic rewriting: Mishchenko, Chatterjee & Brayton 2006), or all in which terms combine,
  /// because several sums together may save operations that none of them saves individually.
  enum class choice { each_shorter, all };

  constexpr sum_shortening(graph& g, const sequence<int>& outputs, const sequence<int>& also_needed,
                           choice which)
      : g_(g), outputs_(outputs), also_needed_(also_needed), choice_(which) {}
  sum_shortening(const sum_shortening&) = delete;
  sum_shortening& operator=(const sum_shortening&) = delete;

  /// Whether any live sum may have terms that combine.
  constexpr bool may_combine() {
    extend_to_new_nodes();
    for (int id : live_values(g_, outputs_))
      if (angles_[id].combining != 0) return true;
    return false;
  }

  constexpr sequence<int> run() {
    const base::zeros<char> live = live_nodes(g_, outputs_);
    extend_to_new_nodes();
    count_uses(live);
    for (int id = 0; id < live.size(); ++id)
      if (live[id] != 0 && uses_[id] != 0) rewrite(id);
    sequence<int> shortened;
    for (int id : outputs_) shortened.push(image_[id]);
    return shortened;
  }

private:
  using set = detail::combinable_angles::set;

  /// A change in the operation counts.
  struct change {
    int products = 0, sums = 0, others = 0, signs = 0;

    constexpr void count(operation op, int times) {
      if (op == operation::multiply)
        products += times;
      else if (detail::is_sum(op))
        sums += times;
      else if (op == operation::negate)
        signs += times;
      else
        others += times;
    }
    constexpr bool is_a_gain() const {
      return products <= 0 && sums <= 0 && others <= 0 && products + sums + others + signs < 0;
    }
  };

  static constexpr bool has_second(const node& n) { return is_binary(n.op) && is_value(n); }

  constexpr void extend_to_new_nodes() {
    angles_.update(g_);
    for (int id = image_.size(); id < g_.size(); ++id)
      image_.push(id), uses_.push(0), is_kept_.push(0), is_outermost_.push(0);
  }
  constexpr void count_uses(const base::zeros<char>& live) {
    for (int id = 0; id < live.size(); ++id) {
      const node& n = g_[id];
      if (live[id] == 0 || is_leaf(n.op)) continue;
      count_use(n.a, n.op);
      if (has_second(n)) count_use(n.b, n.op);
    }
    for (int id : outputs_) count_use(id, operation::negate);
    const base::zeros<char> kept = live_nodes(g_, also_needed_);
    for (int id = 0; id < kept.size(); ++id) is_kept_[id] = kept[id];
  }
  constexpr void count_use(int id, operation by) {
    ++uses_[id];
    if (!detail::is_sum(by)) is_outermost_[id] = 1;
  }
  /// Replaces the operands of a node by their images, then the node by a shorter expression if there is one.
  constexpr void rewrite(int id) {
    const node n = g_[id];
    int now = id;
    if (!is_leaf(n.op)) {
      const int a = image_[n.a], b = has_second(n) ? image_[n.b] : n.b;
      if (a != n.a || b != n.b) {
        now = build(g_, n.op, a, b);
        extend_to_new_nodes();
        replace_node(id, now);
      }
    }
    if (is_outermost_[id] != 0 && detail::is_sum(g_[now].op) && (angles_[now].combining != 0 || now != id)) {
      const int shorter = shorten(now, now != id);
      replace_node(now, shorter);
      now = shorter;
    }
    image_[id] = now;
  }

  // live nodes, updated as uses are added and removed

  constexpr void add_use(int id) {
    if (uses_[id]++ == 0 && is_kept_[id] == 0) add_uses_of_operands(id);
  }
  constexpr void add_uses_of_operands(int id) {
    const node n = g_[id];
    if (is_leaf(n.op)) return;
    change_.count(n.op, 1);
    add_use(image_[n.a]);
    if (has_second(n)) add_use(image_[n.b]);
  }
  constexpr void remove_use(int id) {
    if (--uses_[id] == 0 && is_kept_[id] == 0) remove_uses_of_operands(id);
  }
  constexpr void remove_uses_of_operands(int id) {
    const node n = g_[id];
    if (is_leaf(n.op)) return;
    change_.count(n.op, -1);
    remove_use(image_[n.a]);
    if (has_second(n)) remove_use(image_[n.b]);
  }
  constexpr bool is_live(int id) const { return uses_[id] > 0 || is_kept_[id] != 0; }

  constexpr void replace_node(int old, int now) {
    if (old == now) return;
    add_use(now);
    uses_[now] += uses_[old] - 1;
    uses_[old] = 0;
    if (is_kept_[old] == 0) remove_uses_of_operands(old);
  }
  constexpr change change_by(int old, int now) {
    change_ = {};
    const int uses = uses_[old];
    add_use(now);
    uses_[old] = 0;
    if (is_kept_[old] == 0) remove_uses_of_operands(old);
    const change found = change_;
    if (is_kept_[old] == 0) add_uses_of_operands(old);
    uses_[old] = uses;
    remove_use(now);
    return found;
  }

  // sums

  /// Shortens a sum. If it changes anyway, common factors of its terms are taken out, too.
  constexpr int shorten(int id, bool changes) {
    const set about = angles_[id].combining;
    visits_left_ = most_visits;
    if (terms_in(id, about, true) > sum_of_monomials::most_terms) return id;
    has_combined_ = changes;
    sum_of_monomials sum = terms_of(id, about);
    if (!sum.fits()) return id;
    if (combine_sine_cosine_squares(g_, sum)) has_combined_ = true;
    if (!has_combined_ && angles_[id].shared == 0) return id;
    const number common = common_coefficient(sum);
    const int now = multiply(g_, g_.constant(common), written(sum * divisor(common)));
    extend_to_new_nodes();
    if (now == id || (choice_ == choice::all && has_combined_)) return now;
    return change_by(id, now).is_a_gain() ? now : id;
  }

  constexpr bool is_multiplied_out(int id, set about) const {
    return detail::is_sum(g_[id].op) && (angles_[id].inside & about) != 0;
  }
  /// The number of terms before any of them combine; the result is "too many" if counting takes too long.
  constexpr int terms_in(int id, set about, bool is_multiplied_out) {
    constexpr int too_many = sum_of_monomials::most_terms + 1;
    const node& n = g_[id];
    if (--visits_left_ < 0) return too_many;
    if (n.op == operation::negate) return terms_in(n.a, about, is_multiplied_out);
    const bool is_sum = detail::is_sum(n.op);
    if (is_sum ? !is_multiplied_out && (angles_[id].inside & about) == 0 : n.op != operation::multiply)
      return n.op == operation::divide ? terms_in(n.a, about, false) : 1;
    const int a = terms_in(n.a, about, is_sum);
    if (a >= too_many) return too_many;
    const int b = terms_in(n.b, about, is_sum), both = is_sum ? a + b : a * b;
    return both < too_many ? both : too_many;
  }

  /// The terms of a sum; products are multiplied out if their sums have factors of the given angles.
  constexpr sum_of_monomials terms_of(int id, set about) {
    const node n = g_[id];
    if (!detail::is_sum(n.op)) return product_at(id, about);
    const sum_of_monomials a = terms_of(n.a, about);
    sum_of_monomials b = terms_of(n.b, about);
    if (n.op == operation::subtract) b.negate();
    const sum_of_monomials sum = a + b;
    if (sum.size() < a.size() + b.size()) has_combined_ = true;
    return sum;
  }
  constexpr sum_of_monomials product_at(int id, set about) {
    const node n = g_[id];
    if (n.op == operation::negate) {
      sum_of_monomials negated = product_at(n.a, about);
      negated.negate();
      return negated;
    }
    if (is_multiplied_out(id, about)) return terms_of(id, about);
    if (n.op == operation::multiply || n.op == operation::divide) {
      const sum_of_monomials a = product_at(n.a, about), b = product_at(n.b, about);
      if (n.op == operation::multiply) return a * b; // g++ 12: no temporary in a conditional expression
      return a * inverse_of(n.b, b);
    }
    monomial m;
    if (n.op == operation::constant)
      m.coefficient = g_.number_at(id);
    else
      m.multiply_by(id, 1);
    return sum_of_monomials(m);
  }
  static constexpr sum_of_monomials inverse_of(int id, const sum_of_monomials& written_out) {
    monomial inverse;
    if (written_out.size() != 1 || written_out[0].coefficient == exactly(0)) {
      inverse.multiply_by(id, -1);
      return sum_of_monomials(inverse);
    }
    inverse.coefficient = exactly(1) / written_out[0].coefficient;
    for (int i = 0; i < written_out[0].count; ++i)
      inverse.multiply_by(written_out[0].powers[i].factor, -written_out[0].powers[i].exponent);
    return sum_of_monomials(inverse);
  }

  /// The coefficient that all terms share up to sign, otherwise 1; it stays in front of the sum, where other
  /// rules can find it.
  static constexpr number common_coefficient(const sum_of_monomials& sum) {
    if (sum.size() == 0) return exactly(1);
    const number first = sum[0].coefficient;
    for (const monomial& m : sum)
      if (!(m.coefficient == first) && !(m.coefficient == -first)) return exactly(1);
    return first.negative() ? -first : first;
  }
  static constexpr sum_of_monomials divisor(const number& common) {
    monomial inverse;
    inverse.coefficient = exactly(1) / common;
    return sum_of_monomials(inverse);
  }

  /// Writes a sum, repeatedly taking out the factor that most terms share.
  constexpr int written(const sum_of_monomials& sum) {
    if (sum.size() == 0) return graph::zero;
    if (sum.size() == 1) return written(sum[0]);
    monomial::power common;
    int most = 1;
    for (const monomial& m : sum)
      for (int i = 0; i < m.count; ++i) {
        const monomial::power one{m.powers[i].factor, m.powers[i].exponent > 0 ? 1 : -1};
        int count = 0;
        for (const monomial& other : sum) count += has(other, one) ? 1 : 0;
        if (count > most) most = count, common = one;
      }
    sum_of_monomials inner, rest;
    for (const monomial& m : sum) {
      if (most == 1 ? &m == sum.begin() : has(m, common)) {
        monomial divided = m;
        if (most > 1) divided.multiply_by(common.factor, -common.exponent);
        inner.add(divided);
      } else {
        rest.add(m);
      }
    }
    int first = written(inner);
    if (most > 1)
      first = common.exponent > 0 ? multiply(g_, common.factor, first) : divide(g_, first, common.factor);
    return add(g_, first, written(rest));
  }
  static constexpr bool has(const monomial& m, const monomial::power& common) {
    return m.exponent_of(common.factor) * common.exponent > 0;
  }
  constexpr int written(const monomial& m) {
    const int above = product_of(m, 1), below = product_of(m, -1), coefficient = g_.constant(m.coefficient);
    return multiply(g_, coefficient, below == graph::one ? above : divide(g_, above, below));
  }
  /// The product of all powers whose exponents have the given sign. Existing live products are reused.
  constexpr int product_of(const monomial& m, int sign) {
    sequence<int> factors;
    for (int i = 0; i < m.count; ++i)
      for (int k = 0; k < sign * m.powers[i].exponent; ++k) factors.push(m.powers[i].factor);
    if (factors.empty()) return graph::one;
    while (factors.size() > 1) {
      int first = 0, second = 1;
      for (int i = factors.size() - 1; i > 0; --i)
        for (int j = i - 1; j >= 0; --j)
          if (is_live_product(factors[i], factors[j])) first = j, second = i;
      const int product = multiply(g_, factors[first], factors[second]);
      factors[first] = product;
      for (int i = second; i + 1 < factors.size(); ++i) factors[i] = factors[i + 1];
      factors.pop();
    }
    return factors[0];
  }
  constexpr bool is_live_product(int a, int b) const {
    const int id = g_.find({operation::multiply, a < b ? a : b, a < b ? b : a});
    return id >= 0 && id < uses_.size() && is_live(id);
  }

  graph& g_;
  const sequence<int>&outputs_, &also_needed_;
  choice choice_;
  detail::combinable_angles angles_{};
  sequence<int> image_{}; ///< the replacement of each node
  sequence<int> uses_{};
  sequence<char> is_kept_{};      ///< live regardless of the outputs
  sequence<char> is_outermost_{}; ///< not part of a longer sum
  change change_{};
  static constexpr int most_visits = 200;
  int visits_left_ = 0;
  bool has_combined_ = false;
};

/// Combines sin² + cos² in the outputs if that saves operations, and otherwise returns the outputs unchanged.
/// A small gain is not worthwhile, because later derivatives share parts of the sums. The nodes in
/// `also_needed` are needed regardless of the outputs. Long equations are skipped, because this step would
/// take longer for them than the derivation.
constexpr sequence<int> shorten_sums(graph& g, const sequence<int>& outputs,
                                     const sequence<int>& also_needed) {
  constexpr int most_operations = 200, least_part = 16;
  const base::zeros<char> nothing, kept = live_nodes(g, also_needed);
  const auto operations = [&](const sequence<int>& nodes, const base::zeros<char>& without) {
    const base::zeros<char> live = live_nodes(g, nodes);
    int count = 0;
    for (int id = 0; id < live.size(); ++id)
      if (live[id] != 0 && !is_leaf(g[id].op) && (id >= without.size() || without[id] == 0)) ++count;
    return count;
  };
  if (operations(outputs, nothing) > most_operations) return outputs;
  const int before = operations(outputs, kept);
  sequence<int> best = outputs;
  int most = before - (before < least_part ? 1 : before / least_part);
  for (const auto which : {sum_shortening::choice::each_shorter, sum_shortening::choice::all}) {
    sum_shortening sums(g, outputs, also_needed, which);
    if (!sums.may_combine()) return outputs;
    const sequence<int> found = sums.run();
    if (const int count = operations(found, kept); count <= most) best = found, most = count - 1;
  }
  return best;
}

} // namespace kanexpr::symbolic
