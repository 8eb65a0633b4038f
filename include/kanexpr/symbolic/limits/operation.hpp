#pragma once

#include <kanexpr/symbolic/limits/inverses.hpp>

namespace kanexpr::symbolic::taylor {

/// Whether the first term decides what an operation gives, and vanishes for some values of the symbols.
inline bool is_piecewise(operation op, const series& a, const series& b) {
  const auto is_unsure = [](const series& s) { return s.has_terms() && s.lead().at().vanish_partly(); };
  switch (op) {
  case operation::divide: return is_unsure(b);
  case operation::atan2: return is_unsure(a) || is_unsure(b);
  case operation::power:
  case operation::sqrt:
  case operation::log:
  case operation::abs:
  case operation::sign: return is_unsure(a);
  default: return false;
  }
}

/// One operation that is no linear system.
inline expansion apply(operation op, const series& a, const series& b) {
  if (is_piecewise(op, a, b)) return obstacle::piecewise;
  switch (op) {
  case operation::negate: return -a;
  case operation::add: return a + b;
  case operation::subtract: return a - b;
  case operation::multiply: return a * b;
  case operation::divide: return quotient(a, b);
  case operation::power: {
    if (b.is_constant()) return power(a, b[0]);
    const expansion logarithm = log(a);
    return logarithm ? exp(b * *logarithm) : logarithm;
  }
  case operation::sqrt: return sqrt(a);
  case operation::sin:
  case operation::cos: return sine(a, op);
  case operation::tan: return tan(a);
  case operation::asin:
  case operation::acos: return arcsine(a, op);
  case operation::atan: return atan(a);
  case operation::atan2: return atan2(a, b);
  case operation::exp: return exp(a);
  case operation::log: return log(a);
  case operation::abs: return magnitude(a);
  default: return sign(a);
  }
}

} // namespace kanexpr::symbolic::taylor
