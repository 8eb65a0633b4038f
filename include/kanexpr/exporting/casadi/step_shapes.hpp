#pragma once

#include <kanexpr/exporting/casadi/kernels.hpp>
#include <kanexpr/steps/tableaux.hpp>

#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// The entries of a matrix that may be nonzero.
struct pattern {
  int rows = 0, columns = 0;
  std::vector<char> entries{};

  pattern() = default;
  pattern(int rows_, int columns_) : rows(rows_), columns(columns_), entries(place(rows_, 0), 0) {}
  char& operator()(int i, int j) { return entries[place(i, j)]; }
  char operator()(int i, int j) const { return entries[place(i, j)]; }

  void add_row(int i, const pattern& from, int row) {
    for (int j = 0; j < columns; ++j) (*this)(i, j) |= from(row, j);
  }

private:
  std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(j);
  }
};

/// Row and column of each entry of the derivatives of the rates, in the order of the arguments of a step.
using entry_places = std::vector<std::pair<int, int>>;

/// The sparsity of the derivatives of a step, found by applying the chain rule to sparsity patterns.
class step_shapes {
public:
  step_shapes() = default;
  /// `h` and `t` are the columns of the step length and of the time; `t` is −1 if there is no time argument.
  step_shapes(const steps::tableau& method, int coordinates, int states, int columns, int h, int t,
              const entry_places& slope, const entry_places& bend, const entry_places& curve)
      : first(states, columns), along(states, columns), second(columns, columns), states_(states),
        columns_(columns), h_(h), t_(t) {
    pattern point(states, columns), bent(states, columns);
    for (int i = 0; i < states; ++i) point(i, i) = first(i, i) = 1;
    for (int s = 0; s < method.stages; ++s) {
      add_second(point, slope, curve);
      pattern change = chained(slope, point, states), change_along = chained(bend, point, states);
      for (const auto& [row, column] : slope)
        if (column < states) change_along.add_row(row, bent, column);
      for (int i = 0; i < states; ++i)
        change(i, h) = change_along(i, h) = 1, change_along.add_row(i, change, i);
      point = bent = pattern(states, columns);
      for (int i = 0; i < states; ++i) {
        const std::size_t part = i >= coordinates ? 1 : 0;
        point(i, i) = 1;
        if (method.at(s).b[part] > 0) first.add_row(i, change, i), along.add_row(i, change_along, i);
        if (s + 1 == method.stages || !(method.at(s + 1).a[part] > 0)) continue;
        point.add_row(i, change, i), bent.add_row(i, change_along, i);
      }
    }
  }

  pattern first{}, along{}, second{}; ///< ∂x⁺/∂z, ∂((∂x⁺/∂z) v)/∂z and ∂²(λᵀx⁺)/∂z²

private:
  /// The derivatives with respect to the arguments of the step, computed from those with respect to the
  /// arguments of a stage.
  pattern chained(const entry_places& places, const pattern& point, int rows) const {
    pattern all(rows, columns_);
    for (const auto& [row, column] : places) {
      if (column < states_)
        all.add_row(row, point, column);
      else
        all(row, column) = 1;
      if (column == t_) all(row, h_) = 1;
    }
    return all;
  }

  void add_second(const pattern& point, const entry_places& slope, const entry_places& curve) {
    const pattern rates = chained(slope, point, states_), moved = chained(curve, point, columns_);
    for (int c = 0; c < columns_; ++c) {
      for (int i = 0; i < states_; ++i) {
        if (rates(i, c)) second(c, h_) = second(h_, c) = 1;
        if (point(i, c)) second.add_row(c, moved, i);
      }
      if (c >= states_) second.add_row(c, moved, c);
      if (c == t_) second.add_row(h_, moved, c);
    }
  }

  int states_ = 0, columns_ = 0, h_ = 0, t_ = 0;
};

} // namespace kanexpr::exporting
