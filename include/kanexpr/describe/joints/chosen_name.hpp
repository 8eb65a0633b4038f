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

/// Prefixes the name of a joint: "q" and Link2 give q_Link2.
template <text what, class Type>
inline constexpr auto name_before = [] {
  text<what.view().size() + name_size<Type> + 2> all;
  char* to = all.letters;
  for (const char c : what.view()) *to++ = c;
  *to++ = '_';
  append_name_of<Type>(to);
  return all;
}();

/// Appends a suffix to the name of a joint: Link2 and "home" give Link2_home.
template <class Type, text what>
inline constexpr auto name_behind = [] {
  text<what.view().size() + name_size<Type> + 2> all;
  char* to = all.letters + append_name_of<Type>(all.letters);
  *to++ = '_';
  for (const char c : what.view()) *to++ = c;
  return all;
}();

} // namespace kanexpr::describe
