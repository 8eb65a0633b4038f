#pragma once

#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace kanexpr {

namespace base {

/// A character type. C++ silently converts characters to numbers: '2' becomes 50.
template <class Value>
concept letter = std::same_as<Value, char> || std::same_as<Value, wchar_t> || std::same_as<Value, char8_t> ||
                 std::same_as<Value, char16_t> || std::same_as<Value, char32_t>;

} // namespace base

/// @internal A string literal as a template argument: the "q1" of `coordinate<"q1">`.
template <std::size_t size>
struct text {
  char letters[size]{};

  constexpr text() = default;
  constexpr text(const char (&literal)[size]) {
    for (std::size_t i = 0; i < size; ++i) letters[i] = literal[i];
  }
  /// Converts an argument that is not a string literal to an empty text; the code that reads the name rejects
  /// it.
  template <class Type>
    requires(!std::is_convertible_v<const Type&, std::string_view>)
  constexpr text(const Type&) {}

  constexpr std::string_view view() const { return {letters, size - 1}; }
};

template <class Type>
  requires(!std::is_convertible_v<const Type&, std::string_view>)
text(const Type&) -> text<1>;

/// @internal The name of a type with its namespaces, and the position at which the unqualified name begins.
struct whole_name {
  std::string_view whole;
  std::size_t own = 0;
};

/// @internal A text that contains the name of a type as the compiler prints it. Its length is that of the
/// array, because compilers take a step for each letter that they count.
template <class Type>
constexpr std::string_view text_with_name() {
  return {__PRETTY_FUNCTION__, sizeof(__PRETTY_FUNCTION__) - 1};
}
/// @internal The number of letters in front of that name.
inline constexpr std::size_t letters_before_name = text_with_name<int>().find("Type = ") + 7;

/// @internal Returns the name of a type as the compiler prints it.
template <class Type>
constexpr whole_name whole_name_of() {
  const std::string_view whole = text_with_name<Type>().substr(letters_before_name);
  std::size_t end = 0, start = 0;
  for (int depth = 0; end < whole.size(); ++end) {
    const char c = whole[end];
    if (depth == 0 && (c == ';' || c == ']')) break;
    if (c == '<') ++depth;
    if (c == '>') --depth;
    if (depth == 0 && c == ':') start = end + 1;
  }
  return {whole.substr(0, end), start};
}

/// @internal True if the name of a type denotes the same type in every source file: the type is neither in an
/// unnamed namespace, which compilers print in brackets, nor in a function.
template <class Type>
inline constexpr bool is_known_to_all_files =
    whole_name_of<Type>().whole.find_first_of("({") == std::string_view::npos;

/// @internal The unqualified name of a type, as written in the model: `Link<3>`.
template <class Type>
constexpr std::string_view type_name() {
  const whole_name name = whole_name_of<Type>();
  return name.whole.substr(name.own);
}

/// @internal The same, with its namespaces if the other type has the same unqualified name.
template <class Type, class Other>
constexpr std::string_view type_name_beside() {
  const bool is_alike = !std::is_same_v<Type, Other> && type_name<Type>() == type_name<Other>();
  return is_alike ? whole_name_of<Type>().whole : type_name<Type>();
}

} // namespace kanexpr
