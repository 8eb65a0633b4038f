#pragma once

#include <kanexpr/lower/eliminate.hpp>
#include <kanexpr/mechanics/linearization.hpp>
#include <kanexpr/mechanics/status.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kanexpr::runtime {

/// M⁻¹ [A B] of a linearization whose entries are all numbers, by elimination with row exchanges.
class solve_numbers {
public:
  static bool are_numbers(const symbolic::matrix& m) {
    return std::all_of(m.entries.begin(), m.entries.end(), [](const auto& e) { return e.is_constant(); });
  }

  solve_numbers(symbolic::graph& g, const mechanics::implicit_linearization& given)
      : g_(g), order_(given.mass.rows), rates_(g, order_, given.state.columns + given.input.columns) {
    factorize(given.mass);
    int done = 0;
    for (const symbolic::matrix* right : {&given.state, &given.input})
      for (int j = 0; j < right->columns; ++j) solve(*right, j, done++);
  }

  /// Whether M is regular.
  explicit operator bool() const { return is_regular_; }

  /// δ[q̇; u̇; λ] for each state, then each input.
  const symbolic::matrix& rates() const { return rates_; }

private:
  using math = lower::elimination_math<double>;

  double number_at(const symbolic::matrix& m, int i, int j) const {
    return g_.number_at(m(i, j).node()).value();
  }

  /// Every row beside its largest entry.
  void factorize(const symbolic::matrix& m) {
    const symbolic::factors place{order_};
    factors_.resize(static_cast<std::size_t>(place.size()));
    for (int i = 0; i < order_; ++i) {
      double largest = 0;
      for (int j = 0; j < order_; ++j) largest = (std::max)(largest, std::abs(number_at(m, i, j)));
      scales_.push_back(largest > 0 ? 1 / largest : 1);
      for (int j = 0; j < order_; ++j)
        factors_[static_cast<std::size_t>(place.at(i, j))] = scales_.back() * number_at(m, i, j);
    }
    symbolic::factorize<math>(order_, factors_.data());
    is_regular_ =
        factors_[static_cast<std::size_t>(place.least_pivot())] > mechanics::least_regularity<double>();
  }

  void solve(const symbolic::matrix& right, int column, int into) {
    if (!is_regular_) return;
    std::vector<double> x;
    x.reserve(scales_.size());
    for (int i = 0; i < order_; ++i)
      x.push_back(scales_[static_cast<std::size_t>(i)] * number_at(right, i, column));
    symbolic::solve_factorized<math>(order_, factors_.data(), x.data());
    for (int i = 0; i < order_; ++i)
      rates_(i, into) = symbolic::constant(g_, symbolic::real(x[static_cast<std::size_t>(i)]));
  }

  symbolic::graph& g_;
  int order_;
  symbolic::matrix rates_;
  std::vector<double> factors_{}, scales_{};
  bool is_regular_ = false;
};

} // namespace kanexpr::runtime
