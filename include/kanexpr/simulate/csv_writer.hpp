#pragma once

#include <kanexpr/simulate/csv_number.hpp>
#include <kanexpr/simulate/table.hpp>

#include <charconv>
#include <functional>
#include <initializer_list>
#include <ostream>

namespace kanexpr {

namespace simulated {

/// A name as a field: in quotes if it would not be read back without them.
inline std::string csv_field(const std::string& name) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  if (name.find_first_of(",;\t\"\r\n") == std::string::npos && !name.empty() && !is_number(name) &&
      !is_blank(name.front()) && !is_blank(name.back()) && !name.starts_with("\xEF\xBB\xBF"))
    return name;
  std::string field = "\"";
  for (char c : name) field.append(c == '"' ? 2 : 1, c);
  return field + '"';
}

} // namespace simulated

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
  csv_writer(std::ostream& out, std::span<const std::string> names, std::string called = "the stream")
      : out_(out), called_(std::move(called)), columns_(names.size()) {
    table header; // which takes no name twice
    for (const std::string& name : names) {
      if (done_) done_ = header.add(name, {});
      if (!line_.empty()) line_ += ',';
      line_ += simulated::csv_field(name);
    }
    if (done_) write();
  }
  csv_writer(std::ostream& out, std::initializer_list<std::string> names, std::string called = "the stream")
      : csv_writer(out, std::span(names.begin(), names.size()), std::move(called)) {}

  /// Whether the row could be written.
  bool row(std::span<const double> numbers) {
    if (!done_) return false;
    ++rows_;
    if (numbers.size() != columns_) {
      done_ = outcome("row " + std::to_string(rows_) + " has " + std::to_string(numbers.size()) +
                      (numbers.size() == 1 ? " number" : " numbers") + ", the header " +
                      std::to_string(columns_) + (columns_ == 1 ? " name" : " names"));
      return false;
    }
    for (double number : numbers) {
      char digits[32];
      if (!line_.empty()) line_ += ',';
      line_.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
    }
    return write();
  }
  bool row(std::initializer_list<double> numbers) { return row(std::span(numbers.begin(), numbers.size())); }

  /// Hands over what the stream still holds, and says whether all has been written.
  bool finish() {
    if (done_ && !out_.get().flush()) fail(" after row " + std::to_string(rows_));
    return static_cast<bool>(done_);
  }

  explicit operator bool() const { return static_cast<bool>(done_); }
  const std::string& cause() const { return done_.cause(); }

private:
  bool write() {
    line_ += '\n';
    if (!out_.get().write(line_.data(), static_cast<std::streamsize>(line_.size())))
      fail(rows_ == 0 ? " at the header" : " at row " + std::to_string(rows_));
    line_.clear();
    return static_cast<bool>(done_);
  }
  void fail(const std::string& where) { done_ = outcome("writing " + called_ + " failed" + where); }

  std::reference_wrapper<std::ostream> out_; // so that writers can be assigned
  std::string called_;
  std::size_t columns_;
  std::size_t rows_ = 0;
  std::string line_{};
  outcome done_{};
};

/// Writes a whole table; `called` is the stream's name in sentences.
inline outcome write_csv(const table& all, std::ostream& out, const std::string& called = "the stream") {
  csv_writer writer(out, all.names(), called);
  std::vector<double> row(all.columns());
  for (std::size_t i = 0; i < all.rows(); ++i) {
    for (std::size_t j = 0; j < all.columns(); ++j) row[j] = all.values(j)[i];
    if (!writer.row(row)) break;
  }
  writer.finish();
  return outcome(writer.cause());
}

} // namespace kanexpr
