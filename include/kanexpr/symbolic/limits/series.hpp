#pragma once

#include <kanexpr/symbolic/limits/coefficient.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::limits {

/// A truncated Laurent series in ε: terms from a first order, whose coefficient is nonzero, up to the order
/// from which the series is unknown. A polynomial is known to all orders.
///
/// Arithmetic: Knuth, The Art of Computer Programming 2 (1997), section 4.7; Griewank & Walther, Evaluating
/// Derivatives (2008), section 13.2.
class series {
public:
  static constexpr int all_orders = 1 << 20;

  series() = default; // zero
  explicit series(const coefficient& constant) : series(0, {constant}, all_orders, all_orders) {}
  /// The terms from order `first`; the series is unknown from order `end`, and terms beyond the order `most`
  /// are dropped.
  series(int first, std::vector<coefficient> terms, int end, int most)
      : first_(first), end_(end), max_order_(most), terms_(std::move(terms)) {
    const int kept = (std::min)(end_, max_order_ + 1) - first_;
    if (kept < size()) {
      const auto cut = terms_.begin() + (std::max)(kept, 0);
      if (std::any_of(cut, terms_.end(), [](const coefficient& c) { return !c.is_zero(); }))
        end_ = (std::min)(end_, max_order_ + 1);
      terms_.erase(cut, terms_.end());
    }
    while (!terms_.empty() && terms_.back().is_zero()) terms_.pop_back();
    const auto lead =
        std::find_if(terms_.begin(), terms_.end(), [](const coefficient& c) { return !c.is_zero(); });
    first_ += static_cast<int>(lead - terms_.begin());
    terms_.erase(terms_.begin(), lead);
  }
  /// constant + slope·ε
  static series linear(const coefficient& constant, const coefficient& slope, int most) {
    return {0, {constant, slope}, all_orders, most};
  }

  bool has_terms() const { return !terms_.empty(); }
  bool is_zero() const { return terms_.empty() && end_ == all_orders; }
  bool is_constant() const { return end_ == all_orders && (terms_.empty() || (first_ == 0 && size() == 1)); }
  /// The order of the first term; if there are no terms, the order from which the series is unknown.
  int order() const { return terms_.empty() ? end_ : first_; }
  int end() const { return end_; }
  int max_order() const { return max_order_; }
  /// One past the order of the last term worth computing.
  int computed_end() const { return (std::min)(end_, max_order_ + 1); }
  const coefficient& lead() const { return terms_.front(); }
  coefficient operator[](int k) const {
    const int place = k - first_;
    return place >= 0 && place < size() ? terms_[static_cast<std::size_t>(place)] : coefficient{};
  }
  /// One past the order of the last nonzero term.
  int nonzero_end() const { return terms_.empty() ? end_ : first_ + size(); }

  /// The series times εⁿ.
  series shifted(int n) const {
    if (is_zero()) return *this;
    series moved = *this;
    moved.first_ += n;
    if (end_ != all_orders) moved.end_ += n;
    return moved;
  }

private:
  int size() const { return static_cast<int>(terms_.size()); }

  int first_ = 0;
  int end_ = all_orders;
  int max_order_ = all_orders;
  std::vector<coefficient> terms_{};
};

namespace detail {

/// A series whose terms from `first` to `stop` are given by a function of their order.
template <class Term>
series series_of(int first, int stop, int end, int most, Term term) {
  if (stop > most + 1) stop = most + 1, end = (std::min)(end, stop);
  std::vector<coefficient> terms;
  for (int k = first; k < stop; ++k) terms.push_back(term(k));
  return {first, std::move(terms), end, most};
}

template <class Combine>
series termwise(const series& a, const series& b, Combine combine) {
  const int end = (std::min)(a.end(), b.end());
  const int stop =
      (std::min)(end, (std::max)(a.has_terms() ? a.nonzero_end() : 0, b.has_terms() ? b.nonzero_end() : 0));
  return series_of((std::min)({a.order(), b.order(), stop}), stop, end,
                   (std::min)(a.max_order(), b.max_order()), [&](int k) { return combine(a[k], b[k]); });
}

} // namespace detail

inline series operator+(const series& a, const series& b) {
  return detail::termwise(a, b, [](const coefficient& x, const coefficient& y) { return x + y; });
}
inline series operator-(const series& a, const series& b) {
  return detail::termwise(a, b, [](const coefficient& x, const coefficient& y) { return x - y; });
}
inline series operator-(const series& a) { return series{} - a; }

inline series operator*(const series& a, const series& b) {
  if (a.is_zero() || b.is_zero()) return {};
  const auto reach = [](const series& known, const series& other) {
    return known.end() == series::all_orders ? series::all_orders : known.end() + other.order();
  };
  const int end = (std::min)(reach(a, b), reach(b, a)), first = a.order() + b.order();
  const int stop =
      a.has_terms() && b.has_terms() ? (std::min)(end, a.nonzero_end() + b.nonzero_end() - 1) : first;
  return detail::series_of(first, stop, end, (std::min)(a.max_order(), b.max_order()), [&](int k) {
    coefficient sum;
    for (int j = a.order(); j <= k - b.order() && j < a.nonzero_end(); ++j) sum = sum + a[j] * b[k - j];
    return sum;
  });
}

/// Requires that `b` has terms.
inline series operator/(const series& a, const series& b) {
  if (a.is_zero()) return {};
  const int most = (std::min)(a.max_order(), b.max_order()), first = a.order() - b.order();
  const bool is_single = b.end() == series::all_orders && b.nonzero_end() == b.order() + 1;
  int end = a.end() == series::all_orders ? series::all_orders : a.end() - b.order();
  if (b.end() != series::all_orders) end = (std::min)(end, b.end() - b.order() + first);
  if (!is_single) end = (std::min)(end, most + 1);
  const int stop = !a.has_terms() ? first : is_single ? (std::min)(end, a.nonzero_end() - b.order()) : end;
  std::vector<coefficient> terms;
  for (int k = first; k < stop; ++k) {
    coefficient rest = a[k + b.order()];
    for (int j = first; j < k; ++j)
      rest = rest - b[b.order() + k - j] * terms[static_cast<std::size_t>(j - first)];
    terms.push_back(rest / b.lead());
  }
  return {first, std::move(terms), end, most};
}

/// The derivative with respect to ε.
inline series derivative(const series& a) {
  const int end = a.end() == series::all_orders ? series::all_orders : a.end() - 1;
  if (!a.has_terms()) return {end, {}, end, a.max_order()};
  return detail::series_of(a.order() - 1, a.nonzero_end() - 1, end, a.max_order(),
                           [&](int k) { return coefficient(k + 1) * a[k + 1]; });
}

/// The integral over ε of a series without a term of order -1, plus a constant.
inline series integral(const series& a, const coefficient& constant) {
  const int end = a.end() == series::all_orders ? series::all_orders : a.end() + 1;
  return series(0, {constant}, end, a.max_order()) +
         detail::series_of((std::min)(a.order() + 1, end), a.has_terms() ? a.nonzero_end() + 1 : 0, end,
                           a.max_order(),
                           [&](int k) { return k == 0 ? coefficient{} : a[k - 1] / coefficient(k); });
}

/// The reason why an operation has no series.
enum class obstacle {
  none,
  truncated,         ///< more terms may help
  zero_divisor,      ///< zero along the whole line
  zero_logarithm,    ///< the argument of a logarithm is zero
  infinite_argument, ///< the argument of an exponential or a sine
  not_real,
  fractional_order, ///< non-integer powers of ε
  singular_system,  ///< along the whole line
  piecewise,        ///< the leading term vanishes for some values of the remaining symbols
};

/// A series, or the reason why there is none.
class expansion {
public:
  expansion(series found) : found_(std::move(found)) {}
  expansion(obstacle reason) : reason_(reason) {}

  explicit operator bool() const { return reason_ == obstacle::none; }
  const series& operator*() const { return found_; }
  const series* operator->() const { return &found_; }
  obstacle reason() const { return reason_; }

private:
  series found_{};
  obstacle reason_ = obstacle::none;
};

inline expansion quotient(const series& a, const series& b) {
  if (b.is_zero()) return obstacle::zero_divisor;
  if (!b.has_terms()) return obstacle::truncated;
  return a / b;
}

} // namespace kanexpr::symbolic::limits
