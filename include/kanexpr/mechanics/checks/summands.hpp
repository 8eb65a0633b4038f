#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Numeric values of the summands of an expression.
namespace kanexpr::mechanics {

/// A summand at a generic state.
struct summand {
  symbolic::value_and_rate value{};
  bool is_of_mass = false; ///< contains one of the wanted symbols
};

/// Expands products of sums numerically, without creating expressions.
class summand_expansion {
public:
  /// `wanted` contains the nodes of the symbols to find.
  constexpr summand_expansion(const generic_motion& motion, const graph& g, const sequence<int>& wanted)
      : motion_(motion), g_(g), wanted_(wanted) {}

  constexpr sequence<summand> operator()(expression e) const { return of(e.node()); }

private:
  static constexpr int most = 16; ///< larger products are not expanded

  constexpr sequence<summand> of(int id) const {
    using symbolic::operation;
    const symbolic::node& n = g_[id];
    if (n.op == operation::negate) return scaled_by({-1, 0}, of(n.a));
    if (n.op == operation::add || n.op == operation::subtract) {
      sequence<summand> all = of(n.a);
      const double sign = n.op == operation::add ? 1 : -1;
      for (const summand& s : scaled_by({sign, 0}, of(n.b))) all.push(s);
      return all;
    }
    if (n.op == operation::divide && is_finite(value(n.b)) && !base::equal(value(n.b).value, 0.0)) {
      const symbolic::value_and_rate one_over =
          symbolic::evaluate_with_rate(operation::divide, {1, 0}, value(n.b));
      return scaled_by(one_over, of(n.a));
    }
    if (n.op != operation::multiply) return {{value(id), holds_wanted(id)}};
    const sequence<summand> left = of(n.a), right = of(n.b);
    if (left.size() * right.size() > most) return {{value(id), holds_wanted(id)}};
    sequence<summand> all;
    for (const summand& s : left)
      for (const summand& other : right)
        all.push({product(s.value, other.value), s.is_of_mass || other.is_of_mass});
    return all;
  }

  static constexpr bool is_finite(symbolic::value_and_rate x) {
    return numeric::elementary::detail::is_finite(x.value) && numeric::elementary::detail::is_finite(x.rate);
  }
  /// Multiplies two numbers without computing with NaN or infinity, which constant evaluation rejects.
  static constexpr symbolic::value_and_rate product(symbolic::value_and_rate a, symbolic::value_and_rate b) {
    return is_finite(a) && is_finite(b) ? symbolic::evaluate_with_rate(symbolic::operation::multiply, a, b)
                                        : symbolic::value_and_rate{numeric::elementary::detail::infinity, 0};
  }
  static constexpr sequence<summand> scaled_by(symbolic::value_and_rate factor, sequence<summand> all) {
    for (summand& s : all) s.value = product(factor, s.value);
    return all;
  }

  constexpr const symbolic::value_and_rate& value(int id) const { return motion_.at(id); }
  constexpr bool holds_wanted(int id) const {
    if (wanted_.contains(id)) return true;
    const symbolic::node& n = g_[id];
    return !symbolic::is_leaf(n.op) &&
           (holds_wanted(n.a) || (symbolic::is_binary(n.op) && holds_wanted(n.b)));
  }

  const generic_motion& motion_;
  const graph& g_;
  const sequence<int>& wanted_;
};

/// Whether a subset of the vectors adds up to `whole`, to ten digits of it. The other vectors may be of any
/// size, but larger ones that cancel to `whole` except for their rounding are not found.
constexpr bool is_sum_of_some(const sequence<triple>& given, triple whole) {
  if (given.size() > 10) return false;
  const double most = 1e-10 * length(whole);
  const auto reaches = [&](const auto& next, int from, triple left) -> bool {
    if (length(left) <= most) return true;
    for (int i = from; i < given.size(); ++i)
      if (next(next, i + 1, left - given[i])) return true;
    return false;
  };
  return most > 0 && reaches(reaches, 0, whole);
}

} // namespace kanexpr::mechanics
