#pragma once

#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/limits.hpp>
#include <kanexpr/flexible/sid/document.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace kanexpr::flexible::sid {

/// The order of the indices of m1 and m2, which differs between programs.
enum class index_order { row_amplitude_column, row_column_amplitude };

/// A series with all of its entries.
struct dense {
  int rows = 0, columns = 0, amplitudes = 0;
  std::vector<double> m0{}, m1{}, m2{}; ///< m2 is empty if the series has no terms of second order

  dense(int rows_, int columns_, int amplitudes_, bool has_second_order)
      : rows(rows_), columns(columns_), amplitudes(amplitudes_), m0(size_of(rows_ * columns_)),
        m1(size_of(rows_ * columns_ * amplitudes_)),
        m2(has_second_order ? size_of(rows_ * columns_ * amplitudes_ * amplitudes_) : 0) {}

  double& zeroth(int i, int j) { return m0[size_of(i * columns + j)]; }
  double zeroth(int i, int j) const { return m0[size_of(i * columns + j)]; }
  double& first(int i, int j, int k) { return m1[place_of_first(i, j, k)]; }
  double first(int i, int j, int k) const { return m1[place_of_first(i, j, k)]; }
  void set_second(int i, int j, int k, int l, double value) { m2[place_of_second(i, j, k, l)] = value; }
  /// The second derivative with respect to amplitudes k and l.
  double second(int i, int j, int k, int l) const {
    return m2.empty() ? 0 : m2[place_of_second(i, j, k, l)] + m2[place_of_second(i, j, l, k)];
  }

private:
  static std::size_t size_of(int n) { return static_cast<std::size_t>(n); }
  std::size_t place_of_first(int i, int j, int k) const {
    return size_of((i * columns + j) * amplitudes + k);
  }
  std::size_t place_of_second(int i, int j, int k, int l) const {
    return place_of_first(i, j, k) * size_of(amplitudes) + size_of(l);
  }
};

/// The column and the amplitudes of an entry of m1 or m2.
struct place {
  int column = 0, amplitude = 0, other_amplitude = 0;
};
inline place place_of(const entry& e, index_order order) {
  const bool is_second = e.fourth != 0;
  if (order == index_order::row_column_amplitude) return {e.second, e.third, is_second ? e.fourth : e.third};
  return is_second ? place{e.fourth, e.second, e.third} : place{e.third, e.second, e.second};
}

inline bool is_within(const series& s, const entry& e, index_order order) {
  const place at = place_of(e, order);
  return e.first <= s.rows && at.column <= s.columns && at.amplitude <= s.amplitudes &&
         at.other_amplitude <= s.amplitudes;
}

/// Visits all series of a document.
template <class Visit>
void each_series(const document& d, Visit&& visit) {
  for (const series& s : d.matrices) visit(s);
  for (const node& n : d.nodes)
    for (const series* s : {&n.origin, &n.phi, &n.psi, &n.orientation}) visit(*s);
}

/// The number of entries that lie outside of their matrices.
inline int entries_outside(const document& d, index_order order) {
  int outside = 0;
  each_series(d, [&](const series& s) {
    for (const std::vector<entry>* entries : {&s.m1, &s.m2})
      for (const entry& e : *entries) outside += is_within(s, e, order) ? 0 : 1;
  });
  return outside;
}

/// The order of indices with which the entries fit into their matrices.
inline index_order order_of(const document& d) {
  return entries_outside(d, index_order::row_column_amplitude) <
                 entries_outside(d, index_order::row_amplitude_column)
             ? index_order::row_column_amplitude
             : index_order::row_amplitude_column;
}

inline std::string size_text(int rows, int columns) {
  return std::to_string(rows) + (rows == 1 ? " row and " : " rows and ") + std::to_string(columns) +
         (columns == 1 ? " column" : " columns");
}

namespace detail {

inline bool check_size(const series& s, int rows, int columns, int amplitudes, file_report& report) {
  const std::string called(s.called);
  if (s.rows != rows || s.columns != columns)
    return report.fail(s.line, called + " has " + size_text(s.rows, s.columns) + "; expected " +
                                   size_text(rows, columns));
  if (!(s.m1.empty() && s.m2.empty()) && s.amplitudes != amplitudes)
    return report.fail(s.line, called + " depends on " + std::to_string(s.amplitudes) +
                                   " amplitudes; expected " + std::to_string(amplitudes) +
                                   ", the value of nelastq");
  if (!s.m2.empty() && !fits_second_order(rows * columns, amplitudes))
    return report.fail(s.line, called + " has terms of second order in " + std::to_string(amplitudes) +
                                   " amplitudes; at most " + std::to_string(most_series_entries) +
                                   " coefficients of a matrix are supported");
  return true;
}

/// The indices of an entry of m1 or m2, in parentheses.
inline std::string indices_text(const entry& e) {
  std::string text = "(" + std::to_string(e.first) + ", " + std::to_string(e.second) + ", ";
  text += std::to_string(e.third);
  if (e.fourth != 0) text += ", " + std::to_string(e.fourth);
  return text + ")";
}

inline bool check_entries(const series& s, index_order order, file_report& report) {
  const std::string called(s.called);
  for (const entry& e : s.m0)
    if (e.first > s.rows || e.second > s.columns)
      return report.fail(e.line, "m0(" + std::to_string(e.first) + ", " + std::to_string(e.second) +
                                     ") is outside of " + called + ", which has " +
                                     size_text(s.rows, s.columns));
  for (const std::vector<entry>* entries : {&s.m1, &s.m2})
    for (const entry& e : *entries)
      if (!is_within(s, e, order))
        return report.fail(e.line, (e.fourth == 0 ? "m1" : "m2") + indices_text(e) + " is outside of " +
                                       called + ", which has " + std::to_string(s.rows) + " rows, " +
                                       std::to_string(s.columns) + " columns and " +
                                       std::to_string(s.amplitudes) + " amplitudes");
  return true;
}

} // namespace detail

/// Whether a series has the expected size; otherwise, the report contains the mistake. A series that is
/// missing or contains no numbers has any size.
inline bool is_valid(const series& s, int rows, int columns, int amplitudes, index_order order,
                     file_report& report) {
  const bool is_empty = s.m0.empty() && s.m1.empty() && s.m2.empty();
  if (!s.is_given() || (is_empty && s.structure != structure::unit)) return true;
  return detail::check_size(s, rows, columns, amplitudes, report) && detail::check_entries(s, order, report);
}

/// The entries of a valid series. Entries that the structure implies are completed.
inline dense dense_of(const series& s, int rows, int columns, int amplitudes, index_order order) {
  dense all(rows, columns, amplitudes, !s.m2.empty());
  if (s.is_given() && s.structure == structure::unit)
    for (int i = 0; i < rows && i < columns; ++i) all.zeroth(i, i) = 1;
  const auto set = [&](bool mirrored) {
    for (const entry& e : s.m0) {
      const int i = e.first - 1, j = e.second - 1;
      all.zeroth(mirrored ? j : i, mirrored ? i : j) = e.value;
    }
    for (const std::vector<entry>* entries : {&s.m1, &s.m2})
      for (const entry& e : *entries) {
        const place at = place_of(e, order);
        const int row = e.first - 1, column = at.column - 1, k = at.amplitude - 1;
        const int i = mirrored ? column : row, j = mirrored ? row : column;
        if (e.fourth == 0)
          all.first(i, j, k) = e.value;
        else
          all.set_second(i, j, k, at.other_amplitude - 1, e.value);
      }
  };
  if (s.structure == structure::symmetric && rows == columns) set(true);
  set(false);
  return all;
}

} // namespace kanexpr::flexible::sid
