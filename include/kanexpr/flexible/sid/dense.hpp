#pragma once

#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/sid/document.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace kanexpr::flexible::sid {

/// The order of the three indices of m1, which differs between programs.
enum class index_order { row_amplitude_column, row_column_amplitude };

/// A series with all of its entries.
struct dense {
  int rows = 0, columns = 0, amplitudes = 0;
  std::vector<double> m0{}, m1{};

  dense(int rows_, int columns_, int amplitudes_)
      : rows(rows_), columns(columns_), amplitudes(amplitudes_), m0(size_of(rows_ * columns_)),
        m1(size_of(rows_ * columns_ * amplitudes_)) {}

  double& zeroth(int i, int j) { return m0[size_of(i * columns + j)]; }
  double zeroth(int i, int j) const { return m0[size_of(i * columns + j)]; }
  double& first(int i, int j, int k) { return m1[size_of((i * columns + j) * amplitudes + k)]; }
  double first(int i, int j, int k) const { return m1[size_of((i * columns + j) * amplitudes + k)]; }

private:
  static std::size_t size_of(int n) { return static_cast<std::size_t>(n); }
};

/// The column and the amplitude of an entry of m1.
struct place {
  int column = 0, amplitude = 0;
};
inline place place_of(const entry& e, index_order order) {
  return order == index_order::row_amplitude_column ? place{e.third, e.second} : place{e.second, e.third};
}

inline bool is_within(const series& s, const entry& e, index_order order) {
  const place at = place_of(e, order);
  return e.first <= s.rows && at.column <= s.columns && at.amplitude <= s.amplitudes;
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
    for (const entry& e : s.m1) outside += is_within(s, e, order) ? 0 : 1;
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
  if (!s.m1.empty() && s.amplitudes != amplitudes)
    return report.fail(s.line, called + " depends on " + std::to_string(s.amplitudes) +
                                   " amplitudes; expected " + std::to_string(amplitudes) +
                                   ", the value of nelastq");
  return true;
}

inline bool check_entries(const series& s, index_order order, file_report& report) {
  const std::string called(s.called);
  for (const entry& e : s.m0)
    if (e.first > s.rows || e.second > s.columns)
      return report.fail(e.line, "m0(" + std::to_string(e.first) + ", " + std::to_string(e.second) +
                                     ") is outside of " + called + ", which has " +
                                     size_text(s.rows, s.columns));
  for (const entry& e : s.m1)
    if (!is_within(s, e, order))
      return report.fail(e.line, "m1(" + std::to_string(e.first) + ", " + std::to_string(e.second) + ", " +
                                     std::to_string(e.third) + ") is outside of " + called + ", which has " +
                                     std::to_string(s.rows) + " rows, " + std::to_string(s.columns) +
                                     " columns and " + std::to_string(s.amplitudes) + " amplitudes");
  return true;
}

} // namespace detail

/// Whether a series has the expected size; otherwise, the report contains the mistake. A series that is
/// missing or contains no numbers has any size.
inline bool is_valid(const series& s, int rows, int columns, int amplitudes, index_order order,
                     file_report& report) {
  if (!s.is_given() || (s.m0.empty() && s.m1.empty() && s.structure != structure::unit)) return true;
  return detail::check_size(s, rows, columns, amplitudes, report) && detail::check_entries(s, order, report);
}

/// The entries of a valid series. Entries that the structure implies are completed.
inline dense dense_of(const series& s, int rows, int columns, int amplitudes, index_order order) {
  dense all(rows, columns, amplitudes);
  if (s.is_given() && s.structure == structure::unit)
    for (int i = 0; i < rows && i < columns; ++i) all.zeroth(i, i) = 1;
  const auto set = [&](bool mirrored) {
    for (const entry& e : s.m0) {
      const int i = e.first - 1, j = e.second - 1;
      all.zeroth(mirrored ? j : i, mirrored ? i : j) = e.value;
    }
    for (const entry& e : s.m1) {
      const place at = place_of(e, order);
      const int i = e.first - 1, j = at.column - 1;
      all.first(mirrored ? j : i, mirrored ? i : j, at.amplitude - 1) = e.value;
    }
  };
  if (s.structure == structure::symmetric && rows == columns) set(true);
  set(false);
  return all;
}

} // namespace kanexpr::flexible::sid
