#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::flexible {

/// Returns text from a file for use in a message: truncated and without control characters.
inline std::string printable(std::string_view text, std::size_t most = 60) {
  std::string plain;
  for (char c : text.substr(0, most))
    plain += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f ? '?' : c;
  return text.size() > most ? plain + "..." : plain;
}

/// The first mistake in a file, and notes about contents that were ignored or completed.
class file_report {
public:
  explicit file_report(std::string called) : called_(std::move(called)) {}

  const std::string& mistake() const { return mistake_; }
  const std::vector<std::string>& notes() const { return notes_; }

  /// Reports a mistake in a line, or in the whole file if the number of the line is 0.
  bool fail(int line, const std::string& what) {
    if (mistake_.empty()) mistake_ = at(line) + what;
    return false;
  }
  /// Reports a mistake that concerns the whole file.
  bool fail(const std::string& what) { return fail(0, what); }
  void note(int line, const std::string& what) { add_note(at(line) + what); }
  void note(const std::string& what) { note(0, what); }

private:
  static constexpr std::size_t max_notes = 20;

  std::string at(int line) const {
    if (line == 0) return called_.empty() ? "" : called_ + ": ";
    return "line " + std::to_string(line) + (called_.empty() ? "" : " of " + called_) + ": ";
  }
  void add_note(const std::string& text) {
    if (notes_.size() < max_notes)
      notes_.push_back(text);
    else if (notes_.size() == max_notes)
      notes_.emplace_back("further notes are not listed");
  }

  std::string called_;
  std::string mistake_{};
  std::vector<std::string> notes_{};
};

} // namespace kanexpr::flexible
