#pragma once

#include <kanexpr/exporting/exported_system.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// The sparsity of an input or output of a CasADi function: dense, or the positions of its entries in column
/// order.
struct casadi_sparsity {
  int rows = 0, columns = 0;
  bool is_dense = false;
  std::vector<std::pair<int, int>> places{}; ///< column and row

  static casadi_sparsity dense(int rows) { return {rows, 1, true, {}}; }
  static casadi_sparsity empty(int rows, int columns) { return {rows, columns, false, {}}; }
  static casadi_sparsity of(const exported_result& result) {
    casadi_sparsity found = empty(result.rows, result.columns);
    for (std::size_t i = 0; i < result.row_of.size(); ++i)
      found.places.emplace_back(result.column_of[i], result.row_of[i]);
    return found;
  }

  int entries() const { return is_dense ? rows * columns : static_cast<int>(places.size()); }

  /// The transpose, and the index of each of its entries in this one.
  std::pair<casadi_sparsity, std::vector<int>> transposed() const {
    std::vector<std::pair<std::pair<int, int>, int>> exchanged;
    exchanged.reserve(places.size());
    for (const auto& [column, row] : places)
      exchanged.push_back({{row, column}, static_cast<int>(exchanged.size())});
    std::sort(exchanged.begin(), exchanged.end());
    casadi_sparsity found = empty(columns, rows);
    std::vector<int> from;
    for (const auto& [place, before] : exchanged) {
      found.places.push_back(place);
      from.push_back(before);
    }
    return {found, from};
  }

  /// The encoding that CasADi reads: rows, columns and 1, or compressed columns.
  std::vector<int> numbers() const {
    std::vector<int> all{rows, columns};
    if (is_dense) {
      all.push_back(1);
      return all;
    }
    std::size_t next = 0;
    for (int j = 0; j <= columns; ++j) {
      while (next < places.size() && places[next].first < j) ++next;
      all.push_back(static_cast<int>(next));
    }
    for (const auto& place : places) all.push_back(place.second);
    return all;
  }
};

} // namespace kanexpr::exporting
