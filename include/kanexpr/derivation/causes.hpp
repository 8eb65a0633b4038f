#pragma once

#include <kanexpr/mechanics/problem.hpp>

namespace kanexpr::derivation {

struct cause_sizes {
  int count = 0;
  int letters = 0;
};

/// Why results may have no value at a state: sentences one behind another, each ended by a zero; what is
/// behind the sizes is unused.
template <cause_sizes room>
struct cause_list {
  cause_sizes sizes{};
  int begin[room.count > 0 ? static_cast<std::size_t>(room.count) : 1]{};
  char letters[room.letters > 0 ? static_cast<std::size_t>(room.letters) : 1]{};

  constexpr const char* operator[](int i) const { return letters + begin[i]; }
  constexpr bool has_room_for(const mechanics::problem& p) const {
    return sizes.count < room.count && sizes.letters + p.length < room.letters;
  }
  constexpr void push(const mechanics::problem& p) {
    begin[sizes.count++] = sizes.letters;
    for (char letter : p.view()) letters[sizes.letters++] = letter;
    letters[sizes.letters++] = '\0';
  }
};

/// For constant evaluation only: `trimmed` makes the list that programs use.
inline constexpr cause_sizes room_of_causes{1 << 12, 1 << 18};
using roomy_causes = cause_list<room_of_causes>;

/// The same in arrays of its own sizes, `trimmed<roomy.sizes>(roomy)`.
template <cause_sizes sizes, cause_sizes room>
constexpr cause_list<sizes> trimmed(const cause_list<room>& from) {
  cause_list<sizes> out{};
  out.sizes = sizes;
  for (int i = 0; i < sizes.count; ++i) out.begin[i] = from.begin[i];
  for (int i = 0; i < sizes.letters; ++i) out.letters[i] = from.letters[i];
  return out;
}

} // namespace kanexpr::derivation
