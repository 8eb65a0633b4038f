#pragma once

/// Tables as text: a line of names, then a line for each row, with fields separated by commas and names
/// quoted if necessary (RFC 4180). The unit of a column follows its name in brackets: `q1 [rad]`. Numbers
/// have the fewest digits that reproduce the same bits; nan and inf are valid numbers. The format does not
/// depend on the locale.

#include <kanexpr/base/file_path.hpp>
#include <kanexpr/base/outcome.hpp>
#include <kanexpr/simulations/compiled_simulations.hpp>
#include <kanexpr/simulations/tables/table.hpp>

#include <functional>
#include <initializer_list>
#include <iosfwd>
#include <span>
#include <string>
#include <utility>

namespace kanexpr {

/// Writes a table row by row, for runs that are too large to keep in memory:
///
///     csv_writer out(file, {"t", "q1", "u1"});
///     while (…) out.row({t, x[q1], x[u1]});
///     if (!out.finish()) std::cerr << out.cause();
///
/// After a failure, such as a full disk, nothing more is written.
class csv_writer {
public:
  /// `called` is the name of the stream in error messages.
  csv_writer(std::ostream& out, std::span<const std::string> names, std::string called = "the stream");
  csv_writer(std::ostream& out, std::initializer_list<std::string> names, std::string called = "the stream")
      : csv_writer(out, std::span(names.begin(), names.size()), std::move(called)) {}
  /// Returns a writer that continues after a header and `rows` rows.
  static csv_writer resume(std::ostream& out, std::size_t rows, std::size_t columns,
                           std::string called = "the stream") {
    return csv_writer(out, rows, columns, std::move(called));
  }

  /// Writes a row; returns whether that succeeded.
  bool row(std::span<const double> numbers);
  bool row(std::initializer_list<double> numbers) { return row(std::span(numbers.begin(), numbers.size())); }

  /// Flushes the stream; returns whether everything has been written.
  bool finish();

  explicit operator bool() const { return static_cast<bool>(done_); }
  std::string cause() const { return done_.cause(); }

private:
  csv_writer(std::ostream& out, std::size_t rows, std::size_t columns, std::string called)
      : out_(out), called_(std::move(called)), columns_(columns), rows_(rows) {}
  bool write();
  void fail(const std::string& where);

  std::reference_wrapper<std::ostream> out_;
  std::string called_;
  std::size_t columns_, rows_;
  std::string line_{};
  outcome done_{};
};

/// Options of `write_csv` and `csv_file`.
struct csv_options {
  bool with_units = true; ///< writes the units that are known, for example `q1 [rad]`; otherwise only names
};

/// Writes a whole table; `called` is the name of the stream in error messages.
KANEXPR_SIMULATIONS outcome write_csv(const table& all, std::ostream& out,
                                      const std::string& called = "the stream",
                                      const csv_options& options = {});
KANEXPR_SIMULATIONS outcome write_csv(const table& all, const file_path& path,
                                      const csv_options& options = {});

/// Reads a table written by `write_csv` or by another program; on failure the table holds the cause. `called`
/// is the name of the text in error messages. A name such as `q1 [rad]` is that of the column q1 in rad.
KANEXPR_SIMULATIONS table read_csv(std::istream& in, const std::string& called = {});
KANEXPR_SIMULATIONS table read_csv(const file_path& path);

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_SIMULATIONS
#include <kanexpr/simulations/tables/csv.ipp>
#endif
