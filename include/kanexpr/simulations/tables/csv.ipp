#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/simulations/tables/csv.hpp>
#include <kanexpr/simulations/tables/table.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace kanexpr {

namespace simulations {

/// Reads a number from its text. Returns the end of an error message; empty on success.
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

/// Reads a table from text. A record is one line, or several if a quoted field contains line breaks.
class csv_reader {
public:
  /// `called` is the name of the text in error messages; it may be empty.
  csv_reader(std::istream& in, std::string called) : in_(in), called_(std::move(called)) {}

  table read() {
    table names, all;
    std::vector<std::vector<double>> columns;
    if (!next()) {
      if (has_ended()) refuse(" is empty", text());
    } else if (read_header(names)) {
      columns.resize(names.columns());
      while (next() && read_row(names, columns)) continue;
    }
    if (!has_ended()) return table(outcome(mistake_));
    for (std::size_t j = 0; j < columns.size(); ++j) // the names are checked
      static_cast<void>(all.add(names.names()[j], std::move(columns[j]), names.units()[j]));
    return all;
  }

private:
  static constexpr const char* blanks = " \t\r";
  static constexpr const char* lone_return = " contains a carriage return; lines must end with LF or CR LF";

  bool read_header(table& names) {
    if (!has_quotes_) { // only names may need quotes
      for (const auto& [mark, called] : {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}})
        if (fields_.size() == 1 && fields_.front().find(mark) != std::string::npos)
          return refuse(std::string(" uses ") + called + " as separators; it must use commas");
      if (std::ranges::all_of(fields_, is_number))
        return refuse(" contains numbers; it must contain the names of the columns");
    }
    for (const std::string& field : fields_)
      if (const outcome added = add_header(names, field); !added)
        return refuse(" is not a header: " + added.cause());
    return true;
  }

  /// Adds an empty column. If two columns differ only in their units, the second one keeps both as its name.
  static outcome add_header(table& names, const std::string& field) {
    const std::size_t end = field.rfind(" [");
    if (end == std::string::npos || end == 0 || field.back() != ']') return names.add(field, {});
    const std::string name = field.substr(0, end), unit = field.substr(end + 2, field.size() - end - 3);
    return names.add(name, {}, unit) ? outcome() : names.add(field, {});
  }

  bool read_row(const table& names, std::vector<std::vector<double>>& columns) {
    if (fields_.size() != columns.size())
      return refuse(" has " + counted(fields_.size(), "field") + "; expected " +
                    std::to_string(columns.size()));
    for (std::size_t j = 0; j < fields_.size(); ++j) {
      double number = 0;
      if (const std::string_view wrong = read_number(fields_[j], number); !wrong.empty())
        return refuse(": '" + fields_[j] + "' in column " + names.names()[j] + std::string(wrong));
      columns[j].push_back(number);
    }
    return true;
  }

  /// Advances to the next record; returns false at the end of the text and if a record is malformed.
  bool next() {
    line_ = last_ + 1;
    if (!next_line()) return false;
    if (is_blank()) { // allowed only at the end of the text
      while (next_line())
        if (!is_blank()) return refuse(" is empty");
      return false;
    }
    fields_.clear();
    has_quotes_ = false;
    at_ = 0;
    do {
      if (!skip_blanks() || !(holds('"') ? quoted() : plain())) return false;
    } while (holds(',') && ++at_ != 0);
    return true;
  }

  /// Whether the text ended after the last record.
  bool has_ended() {
    if (mistake_.empty() && (in_.bad() || !in_.eof())) refuse(" cannot be read", text());
    return mistake_.empty();
  }

  std::string text() const { return called_.empty() ? "the stream" : called_; }
  std::string record() const {
    return "line " + std::to_string(line_) + (called_.empty() ? "" : " of " + called_);
  }
  /// Sets the mistake, given the end of its sentence; returns false.
  bool refuse(const std::string& why) { return refuse(why, record()); }
  bool refuse(const std::string& why, const std::string& where) {
    mistake_ = where + why;
    return false;
  }

  bool next_line() {
    if (!mistake_.empty() || !std::getline(in_, text_)) return false;
    ++last_;
    if (last_ == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3); // the byte order mark of UTF-8
    if (last_ == 1 && (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF")))
      return refuse(" is not UTF-8 but UTF-16 or UTF-32");
    if (text_.find('\0') != std::string::npos)
      return refuse(" contains a zero byte: it is not text in UTF-8");
    return true;
  }
  bool is_blank() const { return text_.find_first_not_of(blanks) == std::string::npos; }
  bool holds(char c) const { return at_ < text_.size() && text_[at_] == c; }
  bool skip_blanks() {
    const std::size_t from = at_;
    at_ = (std::min)(text_.find_first_not_of(blanks, at_), text_.size());
    return at_ == text_.size() || text_.find('\r', from) >= at_ || refuse(lone_return);
  }
  bool plain() {
    const std::size_t end = (std::min)(text_.find(',', at_), text_.size());
    std::string field = text_.substr(at_, end - at_);
    field.erase(field.find_last_not_of(blanks) + 1);
    if (field.find('\r') != std::string::npos) return refuse(lone_return);
    fields_.push_back(std::move(field));
    at_ = end;
    return true;
  }

  bool quoted() {
    std::string field;
    has_quotes_ = true;
    ++at_;
    for (std::size_t quote = text_.find('"', at_);; quote = text_.find('"', at_)) {
      field.append(text_, at_, quote - at_);
      if (quote == std::string::npos) { // continues on the next line
        field += '\n';
        if (!next_line()) return mistake_.empty() && refuse(" opens a quote that is not closed");
        at_ = 0;
        continue;
      }
      at_ = quote + 1;
      if (!holds('"')) break;
      field += '"'; // a doubled quote
      ++at_;
    }
    fields_.push_back(std::move(field));
    if (!skip_blanks()) return false;
    return at_ == text_.size() || holds(',') || refuse(" has text after a closing quote");
  }

  std::istream& in_;
  std::string called_, text_{}, mistake_{};
  std::size_t at_ = 0;
  bool has_quotes_ = false;
  long line_ = 0, last_ = 0;
  std::vector<std::string> fields_{};
};

/// Returns, for example, "run.csv cannot be opened: No such file or directory".
inline outcome not_opened(const std::string& path) {
  return outcome(path + " cannot be opened: " + std::generic_category().message(errno));
}

} // namespace simulations

KANEXPR_SIMULATIONS csv_writer::csv_writer(std::ostream& out, std::span<const std::string> names,
                                           std::string called)
    : csv_writer(out, 0, names.size(), std::move(called)) {
  table header; // rejects duplicate names
  for (const std::string& name : names) {
    if (done_) done_ = header.add(name, {});
    if (!line_.empty()) line_ += ',';
    line_ += simulations::csv_field(name);
  }
  if (done_) write();
}

KANEXPR_SIMULATIONS bool csv_writer::row(std::span<const double> numbers) {
  if (!done_) return false;
  ++rows_;
  if (numbers.size() != columns_) {
    done_ =
        outcome("row " + std::to_string(rows_) + " has " + simulations::counted(numbers.size(), "number") +
                ", but the header has " + simulations::counted(columns_, "name"));
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

KANEXPR_SIMULATIONS outcome write_csv(const table& all, std::ostream& out, const std::string& called,
                                      const csv_options& options) {
  if (!all) return outcome(all.cause());
  std::vector<std::string> names = all.names();
  for (std::size_t j = 0; j < names.size() && options.with_units; ++j) names[j] = all.header(j);
  csv_writer writer(out, names, called);
  std::vector<double> row(all.columns());
  for (std::size_t i = 0; i < all.rows(); ++i) {
    for (std::size_t j = 0; j < all.columns(); ++j) row[j] = all.values(j)[i];
    if (!writer.row(row)) break;
  }
  writer.finish();
  return outcome(writer.cause());
}

KANEXPR_SIMULATIONS table read_csv(std::istream& in, const std::string& called) {
  return simulations::csv_reader(in, called).read();
}

KANEXPR_SIMULATIONS outcome write_csv(const table& all, const file_path& path, const csv_options& options) {
  if (!all) return outcome(all.cause()); // before a file is replaced
  std::ofstream out(path.text(), std::ios::binary);
  if (!out) return simulations::not_opened(path.text());
  return write_csv(all, out, path.text(), options);
}

KANEXPR_SIMULATIONS table read_csv(const file_path& path) {
  std::ifstream in(path.text(), std::ios::binary);
  if (!in) return table(simulations::not_opened(path.text()));
  return read_csv(in, path.text());
}

} // namespace kanexpr
