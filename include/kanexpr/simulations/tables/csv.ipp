#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/simulations/tables/csv.hpp>
#include <kanexpr/simulations/tables/csv_records.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace kanexpr {

namespace simulations {

/// Reads a number from its text. Returns the end of an error sentence; empty on success.
inline std::string_view read_number(std::string_view text, double& number) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc::result_out_of_range) return " is too large or too small for a double";
  if (error != std::errc() || end != text.data() + text.size()) return " is not a number";
  return {};
}

inline bool is_number(std::string_view text) {
  double number = 0;
  return read_number(text, number).empty();
}

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

inline bool read_header(csv_records& from, table& names) {
  const std::vector<std::string>& fields = from.fields();
  if (!from.has_quotes()) {
    for (const auto& [mark, called] : {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}})
      if (fields.size() == 1 && fields.front().find(mark) != std::string::npos)
        return from.refuse(std::string(" uses ") + called + " as separators; it must use commas");
    if (std::ranges::all_of(fields, is_number))
      return from.refuse(" contains numbers; it must contain the names of the columns");
  }
  for (const std::string& name : fields)
    if (const outcome added = names.add(name, {}); !added)
      return from.refuse(" is not a header: " + added.cause());
  return true;
}

inline bool read_row(csv_records& from, const table& names, std::vector<std::vector<double>>& columns) {
  const std::vector<std::string>& fields = from.fields();
  if (fields.size() != columns.size())
    return from.refuse(" has " + std::to_string(fields.size()) + (fields.size() == 1 ? " field" : " fields") +
                       "; expected " + std::to_string(columns.size()));
  for (std::size_t j = 0; j < fields.size(); ++j) {
    double number = 0;
    if (const std::string_view wrong = read_number(fields[j], number); !wrong.empty())
      return from.refuse(": '" + fields[j] + "' in column " + names.names()[j] + std::string(wrong));
    columns[j].push_back(number);
  }
  return true;
}

/// Returns, for example, "run.csv cannot be opened: No such file or directory".
inline outcome not_opened(const std::string& path) {
  return outcome(path + " cannot be opened: " + std::generic_category().message(errno));
}

} // namespace simulations

KANEXPR_SIMULATIONS csv_writer::csv_writer(std::ostream& out, std::span<const std::string> names,
                                           std::string called)
    : out_(out), called_(std::move(called)), columns_(names.size()) {
  table header; // rejects duplicate names
  for (const std::string& name : names) {
    if (done_) done_ = header.add(name, {});
    if (!line_.empty()) line_ += ',';
    line_ += simulations::csv_field(name);
  }
  if (done_) write();
}

KANEXPR_SIMULATIONS csv_writer::csv_writer(std::ostream& out, std::size_t rows, std::size_t columns,
                                           std::string called)
    : out_(out), called_(std::move(called)), columns_(columns), rows_(rows) {}

KANEXPR_SIMULATIONS csv_writer csv_writer::resume(std::ostream& out, std::size_t rows, std::size_t columns,
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
  if (done_ && !out_.get().flush()) fail(" after row " + std::to_string(rows_));
  return static_cast<bool>(done_);
}

KANEXPR_SIMULATIONS bool csv_writer::write() {
  line_ += '\n';
  if (!out_.get().write(line_.data(), static_cast<std::streamsize>(line_.size())))
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

KANEXPR_SIMULATIONS table read_csv(std::istream& in, const std::string& called) {
  simulations::csv_records records(in, called);
  table all, names;
  std::vector<std::vector<double>> columns;
  if (!records.next()) {
    if (records.has_ended()) records.refuse_text(" is empty");
  } else if (simulations::read_header(records, names)) {
    columns.resize(names.columns());
    while (records.next() && simulations::read_row(records, names, columns)) {
    }
  }
  if (!records.has_ended()) return table(outcome(records.mistake()));
  for (std::size_t j = 0; j < columns.size(); ++j)
    static_cast<void>(all.add(names.names()[j], std::move(columns[j]))); // the names are checked
  return all;
}

KANEXPR_SIMULATIONS outcome write_csv(const table& all, const file_path& path) {
  if (!all) return outcome(all.cause()); // before it replaces a file
  std::ofstream out(path.text(), std::ios::binary);
  if (!out) return simulations::not_opened(path.text());
  return write_csv(all, out, path.text());
}

KANEXPR_SIMULATIONS table read_csv(const file_path& path) {
  std::ifstream in(path.text(), std::ios::binary);
  if (!in) return table(simulations::not_opened(path.text()));
  return read_csv(in, path.text());
}

} // namespace kanexpr
