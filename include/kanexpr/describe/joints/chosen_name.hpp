#pragma once

#include <kanexpr/base/text.hpp>

/// Names that a joint forms from the name of its type: `q_Link2`, `Link2_home`.
namespace kanexpr::describe {

/// Appends the characters of a type's name that are allowed in a name and replaces all others by an
/// underscore: `Link<3>` becomes Link_3.
template <class Type>
constexpr std::size_t append_name_of(char* to) {
  std::size_t size = 0;
  bool gap = false;
  for (const char c : type_name<Type>()) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '_' || static_cast<unsigned char>(c) >= 0x80;
    if (!is_letter) {
      gap = true;
      continue;
    }
    if (gap && size != 0) to[size++] = '_';
    gap = false;
    to[size++] = c;
  }
  return size;
}

template <class Type>
inline constexpr std::size_t name_size = [] {
  char all[type_name<Type>().size() + 1]{};
  return append_name_of<Type>(all);
}();

/// The name of a joint with a prefix or a suffix: `joint_name<"q", Link2>` is q_Link2, and
/// `joint_name<"", Link2, "home">` is Link2_home.
template <text prefix, class Type, text suffix = "">
inline constexpr auto joint_name = [] {
  text<prefix.view().size() + name_size<Type> + suffix.view().size() + 2> all;
  char* to = all.letters;
  for (const char c : prefix.view()) *to++ = c;
  if (!prefix.view().empty()) *to++ = '_';
  to += append_name_of<Type>(to);
  if (!suffix.view().empty()) *to++ = '_';
  for (const char c : suffix.view()) *to++ = c;
  return all;
}();

} // namespace kanexpr::describe
