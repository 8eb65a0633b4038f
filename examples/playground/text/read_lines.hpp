#pragma once

#include "playground/text/line.hpp"
#include "playground/text/read_expression.hpp"
#include "playground/text/scanner.hpp"
#include "playground/text/words.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace playground {

/// The lines of a text, or its first mistake.
struct read_text {
  std::vector<line> lines{};
  mistake wrong{};
};

/// Reads the rest of one line along the pattern of its word.
class line_reader {
public:
  line_reader(scanner& from, const word& of, int number) : from_(from), of_(of), number_(number) {}

  /// Appends the line, or several if its word repeats.
  void run(std::vector<line>& to) {
    do {
      read_ = {.number = number_, .word = std::string(of_.called)};
      pattern_ = of_.pattern;
      read_part(true);
      to.push_back(std::move(read_));
    } while (of_.repeats && from_.take_if(","));
    if (!from_.is_at_end()) from_.fail("unexpected " + from_.next().text + remedy());
  }

private:
  /// Follows the pattern to its end or to the end of an optional part. If the part was omitted, it only adds
  /// empty slots.
  void read_part(bool is_given) {
    while (!pattern_.empty()) {
      const std::string_view item = take_item();
      if (item == "]") return;
      if (item == "[")
        read_part(is_given && next_is(first_item()));
      else if (item.front() == '{')
        read_slot(item.substr(1, item.size() - 2), is_given);
      else if (is_given && !from_.take_if(item))
        from_.fail_expecting('"' + std::string(item) + '"', remedy());
    }
  }

  /// The form of the line, with slots in angle brackets.
  std::string remedy() const {
    std::string form = "; write " + std::string(of_.called) + ' ' + std::string(of_.pattern);
    std::ranges::replace(form, '{', '<'), std::ranges::replace(form, '}', '>');
    for (std::size_t at; (at = form.find(" ,")) != form.npos;) form.erase(at, 1);
    return form;
  }

  std::string_view first_item() const {
    const std::string_view rest = pattern_.substr(pattern_.find_first_not_of(' '));
    return rest.substr(0, rest.find_first_of(" ]"));
  }
  bool next_is(std::string_view item) const { return from_.next().text == item; }

  std::string_view take_item() {
    pattern_.remove_prefix(pattern_.find_first_not_of(' '));
    const std::size_t length = pattern_[0] == '{'                         ? pattern_.find('}') + 1
                               : pattern_[0] == '[' || pattern_[0] == ']' ? 1
                                                                          : pattern_.find_first_of(" ]");
    const std::string_view item = pattern_.substr(0, length);
    pattern_.remove_prefix(item.size());
    return item;
  }

  void read_slot(std::string_view kind, bool is_given) {
    line::slot filled{.is_given = is_given};
    if (is_given) {
      const bool is_list = kind == "scalars" || kind == "vectors" || kind == "symbols";
      if (is_list || kind == "scalar" || kind == "vector" || kind == "number") {
        do filled.written.push_back(expression_reader(from_).sum());
        while (is_list && from_.take_if(","));
      } else if (from_.next().is == token::kind::name) {
        filled.name = from_.take().text;
      } else {
        from_.fail_expecting(kind == "name" ? "a new name" : "a " + std::string(kind), remedy());
      }
    }
    read_.slots.push_back(std::move(filled));
  }

  scanner& from_;
  const word& of_;
  int number_;
  line read_{};
  std::string_view pattern_{};
};

/// Reads a model; stops at the first mistake.
inline read_text read_lines(std::string_view text) {
  read_text all;
  for (int number = 1; !text.empty() && all.wrong.sentence.empty(); ++number) {
    const std::size_t end = text.find('\n');
    scanner from(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    if (from.is_at_end()) continue;
    const token first = from.take();
    if (const word* of = find_word(first.text))
      line_reader(from, *of, number).run(all.lines);
    else
      from.fail("unknown word " + first.text);
    if (!from.mistake().empty()) all.wrong = {number, from.mistake()};
  }
  return all;
}

} // namespace playground
