#pragma once

#include <kanexpr/simulate/tables/csv.hpp>
#include <kanexpr/simulate/tables/csv_number.hpp>

#include <algorithm>
#include <istream>

namespace kanexpr {

namespace simulated {

/// The records of a text: one line each, or several if a quoted field contains line breaks.
class csv_records {
public:
  explicit csv_records(std::istream& in) : in_(in) {}

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

  const std::vector<std::string>& fields() const { return fields_; }
  /// Whether a field is quoted; only names may need quotes.
  bool has_quotes() const { return has_quotes_; }
  /// Returns the line at which the record begins, counted from 1.
  long line() const { return line_; }
  /// Returns the end of an error sentence; empty if the record is well formed.
  const std::string& mistake() const { return mistake_; }

private:
  static constexpr const char* blanks = " \t\r";
  static constexpr const char* lone_return = " contains a carriage return; lines must end with LF or CR LF";

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
  bool refuse(std::string what) {
    mistake_ = std::move(what);
    return false;
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
  std::string text_{}, mistake_{};
  std::size_t at_ = 0;
  bool has_quotes_ = false;
  long line_ = 0, last_ = 0;
  std::vector<std::string> fields_{};
};

class table_reader {
public:
  table_reader(std::istream& in, const std::string& called) : in_(in), called_(called), records_(in) {}

  table read() {
    if (!header()) return table(wrong_);
    while (records_.next())
      if (!row()) return table(wrong_);
    if (!well_formed()) return table(wrong_);
    table all;
    for (std::size_t j = 0; j < columns_.size(); ++j)
      if (outcome added = all.add(header_.names()[j], std::move(columns_[j])); !added)
        return table(std::move(added));
    return all;
  }

private:
  bool header() {
    const bool found = records_.next();
    if (!well_formed()) return false;
    if (!found) return refuse(source() + (in_.eof() ? " is empty" : " cannot be read"));
    if (!records_.has_quotes() && !is_of_names(records_.fields())) return false;
    for (const std::string& name : records_.fields())
      if (const outcome added = header_.add(name, {}); !added)
        return refuse(line() + " is not a header: " + added.cause());
    columns_.resize(header_.columns());
    return true;
  }

  bool is_of_names(const std::vector<std::string>& fields) {
    for (const auto& [mark, called] : {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}})
      if (fields.size() == 1 && fields.front().find(mark) != std::string::npos)
        return refuse(line() + " uses " + called + " as separators; it must use commas");
    if (!std::ranges::all_of(fields, is_number)) return true;
    return refuse(line() + " contains numbers; it must contain the names of the columns");
  }

  bool row() {
    const std::vector<std::string>& fields = records_.fields();
    if (fields.size() != columns_.size())
      return refuse(line() + " has " + std::to_string(fields.size()) +
                    (fields.size() == 1 ? " field" : " fields") + "; expected " +
                    std::to_string(columns_.size()));
    for (std::size_t j = 0; j < fields.size(); ++j) {
      double number = 0;
      if (const std::string_view wrong = read_number(fields[j], number); !wrong.empty())
        return refuse(line() + ": '" + fields[j] + "' in column " + header_.names()[j] + std::string(wrong));
      columns_[j].push_back(number);
    }
    return true;
  }

  bool well_formed() {
    if (!records_.mistake().empty()) return refuse(line() + records_.mistake());
    return in_.bad() ? refuse(source() + " cannot be read") : true;
  }

  std::string source() const { return called_.empty() ? "the stream" : called_; }
  std::string line() const {
    return "line " + std::to_string(records_.line()) + (called_.empty() ? "" : " of " + called_);
  }
  bool refuse(std::string why) {
    wrong_ = outcome(std::move(why));
    return false;
  }

  std::istream& in_;
  std::string called_;
  csv_records records_;
  table header_{}; ///< the names, without rows
  std::vector<std::vector<double>> columns_{};
  outcome wrong_{};
};

} // namespace simulated

KANEXPR_SIMULATIONS table read_csv(std::istream& in, const std::string& called) {
  return simulated::table_reader(in, called).read();
}

} // namespace kanexpr
