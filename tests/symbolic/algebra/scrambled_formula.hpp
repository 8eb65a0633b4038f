#pragma once

#include "symbolic/random_formula.hpp"

/// Pairs of equal expressions that look different: each part is built once directly and once by a theorem. A
/// pair may be made unequal in one place.
class scrambled_formulas {
public:
  using expression = kanexpr::symbolic::expression;
  struct pair {
    expression first, second;
  };

  scrambled_formulas(symbols& s, unsigned seed, bool with_quotients)
      : s_(s), engine_(seed), with_quotients_(with_quotients) {}

  pair make(int depth) {
    if (depth == 0) return leaf();
    switch (pick(with_quotients_ ? 10 : 8)) {
    case 0: return trigonometric();
    case 1: {
      const pair a = make(depth - 1), b = make(depth - 1);
      return {a.first - b.first, -b.second + a.second};
    }
    case 2:
    case 3: {
      const pair a = make(depth - 1), b = make(depth - 1);
      return {a.first + b.first, b.second + a.second};
    }
    case 8: {
      const pair a = make(depth - 1), b = leaf(), c = trigonometric();
      return {a.first / (b.first + s_.m), a.second * (c.second + 3) / ((b.second + s_.m) * (c.first + 3))};
    }
    case 9: return tangent();
    default: {
      const pair a = make(depth - 1), b = make(depth - 2 > 0 ? depth - 2 : 0), c = leaf();
      return {a.first * (b.first + c.first), a.second * c.second + b.second * a.second};
    }
    }
  }

  /// Makes one of the next few leaves slightly different on one side.
  void spoil() { until_spoiled_ = 1 + pick(4); }

  std::vector<std::vector<long double>> points() {
    std::vector<std::vector<long double>> all(3);
    std::uniform_real_distribution<double> any(0.3, 1.4);
    for (std::vector<long double>& point : all)
      for (int i = 0; i < s_.g.symbols().size(); ++i) point.push_back(any(engine_));
    return all;
  }

private:
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

  pair leaf() {
    const expression all[] = {s_.a, s_.b, s_.m, s_.u1, s_.u2, s_.fraction(1 + pick(4), 1 + pick(3))};
    if (pick(3) == 0) return trigonometric();
    const expression e = all[pick(6)];
    return {e, --until_spoiled_ == 0 ? e + s_.fraction(1, 1000) * all[pick(6)] : e};
  }

  expression angle() {
    const expression all[] = {s_.q1, s_.q2, s_.x};
    expression sum = all[pick(3)];
    if (pick(2) == 0) sum += s_.fraction(1 + pick(3), 1 + pick(2)) * all[pick(3)];
    if (pick(3) == 0) sum = sum - all[pick(3)];
    return sum;
  }

  pair trigonometric() {
    const expression a = angle(), b = angle();
    switch (pick(6)) {
    case 0: return {sin(a + b), sin(a) * cos(b) + cos(a) * sin(b)};
    case 1: return {cos(a - b), cos(b) * cos(a) + sin(b) * sin(a)};
    case 2: return {cos(2 * a), 1 - 2 * (sin(a) * sin(a))};
    case 3: return {sin(a) * cos(b), (sin(a + b) - sin(b - a)) / 2};
    case 4: return {cos(3 * a), 4 * (cos(a) * cos(a) * cos(a)) - 3 * cos(a)};
    default: return {sin(a) * sin(a), (1 - cos(2 * a)) / 2};
    }
  }

  pair tangent() {
    expression a = angle();
    while (a.is_constant()) a = angle();
    switch (pick(3)) {
    case 0: return {tan(a), sin(a) / cos(a)};
    case 1: return {tan(a / 2), (1 - cos(a)) / sin(a)};
    default: return {sin(2 * a), 2 * tan(a) / (tan(a) * tan(a) + 1)};
    }
  }

  symbols& s_;
  std::mt19937 engine_;
  bool with_quotients_;
  int until_spoiled_ = 0;
};
