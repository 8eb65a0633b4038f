#pragma once

#include <kanexpr/simulate/tables/csv.hpp>
#include <kanexpr/simulate/tables/csv_number.hpp>

#include <charconv>
#include <ostream>

namespace kanexpr {

namespace simulated {

/// Returns a name as a field, quoted if it would not be read back correctly otherwise.
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

KANEXPR_SIMULATIONS csv_writer::csv_writer(std::ostream& out, std::span<const std::string> names,
                                           std::string called)
    : out_(&out), called_(std::move(called)), columns_(names.size()) {
  table header; // rejects duplicate names
  for (const std::string& name : names) {
    if (done_) done_ = header.add(name, {});
    if (!line_.empty()) line_ += ',';
    line_ += simulated::csv_field(name);
  }
  if (done_) write();
}

KANEXPR_SIMULATIONS csv_writer::csv_writer(std::ostream& out, std::size_t rows, std::size_t columns,
                                           std::string called)
    : out_(&out), called_(std::move(called)), columns_(columns), rows_(rows) {}

KANEXPR_SIMULATIONS csv_writer csv_writer::behind(std::ostream& out, std::size_t rows, std::size_t columns,
                                                  std::string called) {
  return csv_writer(out, rows, columns, std::move(called));
}

KANEXPR_SIMULATIONS bool csv_writer::row(std::span<const double> numbers) {
  if (!done_) return false;
  ++rows_;
  if (numbers.size() != columns_) {
    done_ = outcome("row " + std::to_string(rows_) + " has " + std::to_string(numbers.size()) +
                    (numbers.size() == 1 ? " number" : " numbers") + ", but the header has " +
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

KANEXPR_SIMULATIONS bool csv_writer::finish() {
  if (done_ && !out_->flush()) fail(" after row " + std::to_string(rows_));
  return static_cast<bool>(done_);
}

KANEXPR_SIMULATIONS bool csv_writer::write() {
  line_ += '\n';
  if (!out_->write(line_.data(), static_cast<std::streamsize>(line_.size())))
    fail(rows_ == 0 ? " at the header" : " at row " + std::to_string(rows_));
  line_.clear();
  return static_cast<bool>(done_);
}

KANEXPR_SIMULATIONS void csv_writer::fail(const std::string& where) {
  done_ = outcome("writing " + called_ + " failed" + where);
}

KANEXPR_SIMULATIONS outcome write_csv(const table& all, std::ostream& out, const std::string& called) {
  if (!all) return outcome(all.cause());
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
