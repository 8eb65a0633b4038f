#pragma once

#include <kanexpr/base/name.hpp>

#include <initializer_list>
#include <string>
#include <string_view>

namespace kanexpr::base {

/// A sentence in the language of mechanics that names the entity concerned, or a part of such a sentence. It
/// describes a mistake or the cause of a status or of a failure. Empty if there is nothing to report.
struct sentence {
  static constexpr int capacity = 255;
  char letters[capacity + 1]{};
  int length = 0;

  constexpr sentence() = default;
  /// Names that are too long for a message are shortened in the middle, so that the end of the sentence is
  /// kept and names stay distinct.
  constexpr explicit sentence(std::initializer_list<std::string_view> pieces);

  constexpr explicit operator bool() const { return length != 0; }
  constexpr std::string_view view() const { return {letters, static_cast<std::size_t>(length)}; }
  /// The same text; all types that report a cause have a member of this name.
  constexpr std::string cause() const { return std::string(view()); }

private:
  constexpr void append(std::string_view text);
};

template <class Stream>
auto operator<<(Stream& to, const sentence& told) -> decltype(to << told.view()) {
  return to << told.view();
}

namespace detail {

constexpr std::string_view left_out = "...";

/// Returns the largest length limit per piece for which all pieces fit.
constexpr std::size_t longest_piece_of(std::initializer_list<std::string_view> pieces) {
  std::size_t longest = sentence::capacity;
  for (;; --longest) {
    std::size_t whole = 0;
    for (std::string_view piece : pieces) whole += piece.size() < longest ? piece.size() : longest;
    if (whole <= sentence::capacity || longest <= 2 * left_out.size()) return longest;
  }
}

} // namespace detail

constexpr sentence::sentence(std::initializer_list<std::string_view> pieces) {
  const std::size_t longest = detail::longest_piece_of(pieces);
  for (std::string_view piece : pieces) {
    if (piece.size() <= longest) {
      append(piece);
      continue;
    }
    const std::size_t kept = longest - detail::left_out.size();
    append(piece.substr(0, kept - kept / 2));
    append(detail::left_out);
    append(piece.substr(piece.size() - kept / 2));
  }
}

/// If the shortened pieces still do not fit, the end is cut off.
constexpr void sentence::append(std::string_view text) {
  for (char letter : text) {
    if (length < capacity) {
      letters[length++] = letter;
      continue;
    }
    for (int i = 0; i < static_cast<int>(detail::left_out.size()); ++i)
      letters[capacity - 1 - i] = detail::left_out[static_cast<std::size_t>(i)];
    return;
  }
}

/// Formats an integer for a message.
constexpr base::name counted(int n) {
  name text;
  text.append(n);
  return text;
}

} // namespace kanexpr::base
