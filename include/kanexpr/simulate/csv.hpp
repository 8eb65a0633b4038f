#pragma once

/// Tables as text: a line of names, then a line for each row, with commas between the fields and names in
/// quotes where they need them (RFC 4180). Numbers are the shortest that give the same bits again; nan and
/// inf are numbers. No locale matters.

#include <kanexpr/simulate/compiled_simulations.hpp>
#include <kanexpr/simulate/file_path.hpp>
#include <kanexpr/simulate/table.hpp>

#include <initializer_list>
#include <iosfwd>

namespace kanexpr {

/// Writes a table row by row, for runs that are too large to keep:
///
///     csv_writer out(file, {"t", "q1", "u1"});
///     while (…) out.row({t, x[q1], x[u1]});
///     if (!out.finish()) std::cerr << out.cause();
///
/// After a failure, as of a full disk, nothing more is written.
class csv_writer {
public:
  /// `called` is the stream's name in sentences.
  csv_writer(std::ostream& out, std::span<const std::string> names, std::string called = "the stream");
  csv_writer(std::ostream& out, std::initializer_list<std::string> names, std::string called = "the stream")
      : csv_writer(out, std::span(names.begin(), names.size()), std::move(called)) {}
  /// One that goes on behind a header and so many rows.
  static csv_writer behind(std::ostream& out, std::size_t rows, std::size_t columns,
                           std::string called = "the stream");

  csv_writer(const csv_writer&) = default;
  csv_writer(csv_writer&&) = default;
  csv_writer& operator=(const csv_writer&) = default;
  csv_writer& operator=(csv_writer&&) = default;
  ~csv_writer() = default;

  /// Whether the row could be written.
  bool row(std::span<const double> numbers);
  bool row(std::initializer_list<double> numbers) { return row(std::span(numbers.begin(), numbers.size())); }

  /// Hands over what the stream still holds, and says whether all has been written.
  bool finish();

  explicit operator bool() const { return static_cast<bool>(done_); }
  std::string cause() const { return done_.cause(); }

private:
  csv_writer(std::ostream& out, std::size_t rows, std::size_t columns, std::string called);
  bool write();
  void fail(const std::string& where);

  std::ostream* out_; // so that writers can be assigned
  std::string called_;
  std::size_t columns_;
  std::size_t rows_ = 0;
  std::string line_{};
  outcome done_{};
};

/// Writes a whole table; `called` is the stream's name in sentences.
KANEXPR_SIMULATIONS outcome write_csv(const table& all, std::ostream& out,
                                      const std::string& called = "the stream");
KANEXPR_SIMULATIONS outcome write_csv(const table& all, const file_path& path);

/// Reads a table as `write_csv` writes it, or as other programs do; if it cannot, the table says why.
/// `called` is the name of the text in sentences.
KANEXPR_SIMULATIONS table read_csv(std::istream& in, const std::string& called = {});
KANEXPR_SIMULATIONS table read_csv(const file_path& path);

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_SIMULATIONS
#include <kanexpr/simulate/engine/csv.hpp>
#endif
