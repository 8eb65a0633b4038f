#pragma once

#include "evaluate_graph.hpp"
#include "symbols.hpp"

#include <array>
#include <deque>
#include <random>

/// Random formulas, built twice: by the simplifying builders, and as plain numbers at a few points.
class random_formulas {
public:
  using expression = kanexpr::symbolic::expression;
  using operation = kanexpr::symbolic::operation;
  using real = long double;
  static constexpr std::size_t points = 4;

  struct formula {
    expression e;
    std::array<real, points> value{};
    std::array<real, points> error{}; ///< bound on the rounding error in double
    int operations = 0;               ///< as written, without signs
  };

  random_formulas(symbols& s, unsigned seed, bool smooth = false)
      : symbols_(&s), engine_(seed), smooth_(smooth), at_(points) {
    for (std::vector<real>& point : at_)
      for (int i = 0; i < s.g.symbols().size(); ++i)
        point.push_back(uniform(0.3, 1.7) * (pick(2) == 0 ? -1 : 1));
  }

  /// The values of all symbols.
  const std::vector<real>& point(std::size_t i) const { return at_[i]; }

  formula make(int depth) {
    if (depth == 0 || pick(8) == 0) return leaf();
    if (!recent_.empty() && pick(4) == 0)
      return recent_[engine_() % recent_.size()]; // rules search for equal parts
    for (;;) {
      const formula left = make(depth - 1);
      constexpr operation binary[] = {operation::add,      operation::subtract, operation::multiply,
                                      operation::divide,   operation::add,      operation::subtract,
                                      operation::multiply, operation::atan2};
      constexpr operation unary[] = {operation::negate, operation::sqrt, operation::sin,  operation::cos,
                                     operation::tan,    operation::asin, operation::acos, operation::atan,
                                     operation::exp,    operation::log,  operation::abs,  operation::sign};
      formula result;
      switch (pick(8)) {
      case 0: result = combine(unary[pick(12)], left, left); break;
      case 1: result = combine(operation::power, left, number(pick(9) - 4, 1 + pick(3))); break;
      case 2: result = combine(operation::power, left, make(depth - 1)); break;
      case 3: result = combine(binary[pick(8)], left, left); break;
      default: result = combine(binary[pick(8)], left, make(depth - 1)); break;
      }
      if (result.operations < 0) continue;
      recent_.push_back(result);
      if (recent_.size() > 6) recent_.pop_front();
      return result;
    }
  }

  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

private:
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }

  formula leaf() {
    if (pick(4) == 0) return number(pick(7) - 3, 1 + pick(4));
    if (pick(12) == 0) return constant(symbols_->number(uniform(-2, 2)));
    const expression all[] = {symbols_->a, symbols_->b, symbols_->q1, symbols_->u1};
    formula f{all[pick(4)], {}, {}, 0};
    for (std::size_t i = 0; i < points; ++i) f.value[i] = graph_evaluation::evaluate(f.e, at_[i]);
    return f;
  }

  formula number(int numerator, int denominator) {
    return constant(symbols_->fraction(numerator, denominator));
  }

  formula constant(expression e) {
    formula f{e, {}, {}, 0};
    f.value.fill(graph_evaluation::constant_value<real>(e.owner().number_at(e.node())));
    return f;
  }

  /// The slopes of a result, and whether the operands are well inside the domain.
  struct slope {
    real by_a, by_b;
    bool inside;
  };
  slope slope_of(operation op, real a, real b, real f, bool is_b_constant) const {
    constexpr real margin = 0.05L;
    switch (op) {
    case operation::multiply: return {b, a, true};
    case operation::divide: return {1 / b, f / b, std::abs(b) > margin};
    case operation::power: {
      const bool is_whole = is_b_constant && b == std::round(b) && std::abs(b) <= 4;
      return {b * f / a, is_whole ? 0 : f * std::log(std::abs(a)),
              is_whole ? std::abs(a) > margin : a > margin};
    }
    case operation::sqrt: return {0.5L / f, 0, a > margin};
    case operation::sin: return {1, 0, std::abs(a) < 100};
    case operation::cos: return {1, 0, std::abs(a) < 100};
    case operation::tan: return {1 + f * f, 0, std::abs(f) < 20 && std::abs(a) < 100};
    case operation::asin:
    case operation::acos: return {1 / std::sqrt(1 - a * a), 0, std::abs(a) < 1 - margin};
    case operation::exp: return {f, 0, a < 4};
    case operation::log: return {1 / a, 0, a > margin};
    case operation::abs: return {1, 0, !smooth_ && std::abs(a) > margin};
    case operation::sign: return {0, 0, !smooth_ && std::abs(a) > margin};
    case operation::atan2: {
      const real square = a * a + b * b;
      return {b / square, a / square, !smooth_ && (b > margin || std::abs(a) > margin)};
    }
    default: return {1, 1, true};
    }
  }

  static int cost_as_written(operation op, const formula& exponent) {
    if (op == operation::negate) return 0;
    return op == operation::power ? 6 + exponent.operations : 1;
  }

  formula combine(operation op, const formula& a, const formula& b) {
    const bool is_binary = kanexpr::symbolic::is_binary(op);
    formula f;
    f.operations =
        a.operations + (is_binary && op != operation::power ? b.operations : 0) + cost_as_written(op, b);
    for (std::size_t i = 0; i < points; ++i) {
      f.value[i] = graph_evaluation::arithmetic(op, a.value[i], b.value[i]);
      const slope s = slope_of(op, a.value[i], b.value[i], f.value[i], b.e.is_constant());
      const real wrong = std::abs(s.by_a) * a.error[i] + (is_binary ? std::abs(s.by_b) * b.error[i] : 0);
      f.error[i] = wrong + 4e-16L * std::abs(f.value[i]);
      const bool is_near_branch = op == operation::sign && a.error[i] > 1e-3L;
      if (!s.inside || is_near_branch || !(std::abs(f.value[i]) < 1e4L)) f.operations = -1;
    }
    if (f.operations >= 0) f.e = {symbols_->g, build(symbols_->g, op, a.e.node(), b.e.node())};
    return f;
  }

  std::deque<formula> recent_;
  symbols* symbols_;
  std::mt19937 engine_;
  bool smooth_;
  std::vector<std::vector<real>> at_;
};
