#pragma once

#include <cstddef>
#include <string_view>

namespace kanexpr::describe {

/// The result of checking the number of arguments of a word, and the form that an error sentence suggests.
struct arguments {
  int missing = 0;       ///< -1: too many
  std::string_view form; ///< how to write the word: "offset<Self, From, vector>"
  constexpr explicit operator bool() const { return missing == 0; }
};

constexpr arguments arguments_of(std::string_view form, std::size_t given, std::size_t least,
                                 std::size_t most) {
  return {given < least ? 1 : given > most ? -1 : 0, form};
}
constexpr arguments arguments_of(std::string_view form, std::size_t given, std::size_t wanted) {
  return arguments_of(form, given, wanted, wanted);
}

} // namespace kanexpr::describe
