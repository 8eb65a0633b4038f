#pragma once

#include <algorithm>
#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::simulations {

/// The records of a text: one line each, or several if a quoted field contains line breaks.
class csv_records {
public:
  /// `called` is the name of the text in error sentences; it may be empty.
  csv_records(std::istream& in, std::string called) : in_(in), called_(std::move(called)) {}

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

  /// Whether the text ended after the last record.
  bool has_ended() {
    if (mistake_.empty() && (in_.bad() || !in_.eof())) refuse_text(" cannot be read");
    return mistake_.empty();
  }
  /// Sets the mistake in the current record, given the end of its sentence; returns false.
  bool refuse(const std::string& why) {
    return refuse_text(why, "line " + std::to_string(line_) + (called_.empty() ? "" : " of " + called_));
  }
  /// Sets a mistake in the whole text.
  bool refuse_text(const std::string& why) {
    return refuse_text(why, called_.empty() ? "the stream" : called_);
  }
  /// Returns the mistake, as a sentence.
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
  bool refuse_text(const std::string& why, const std::string& where) {
    mistake_ = where + why;
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
  std::string called_, text_{}, mistake_{};
  std::size_t at_ = 0;
  bool has_quotes_ = false;
  long line_ = 0, last_ = 0;
  std::vector<std::string> fields_{};
};

} // namespace kanexpr::simulations
