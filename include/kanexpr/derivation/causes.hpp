#pragma once

#include <kanexpr/base/sentence.hpp>

#include <cstdint>
#include <string_view>
#include <type_traits>

namespace kanexpr::derivation {

struct cause_sizes {
  int count = 0;
  int letters = 0;
};

/// The reasons why results may have no value at a state, as consecutive sentences. Array elements beyond the
/// sizes are unused.
template <cause_sizes room>
struct cause_list {
  cause_sizes sizes{};
  /// The small type saves memory on microcontrollers.
  std::conditional_t<(room.letters < 1 << 16), std::uint16_t, int>
      end[room.count > 0 ? static_cast<std::size_t>(room.count) : 1]{};
  char letters[room.letters > 0 ? static_cast<std::size_t>(room.letters) : 1]{};

  constexpr std::string_view operator[](int i) const {
    const int begin = i > 0 ? end[i - 1] : 0;
    return {letters + begin, static_cast<std::size_t>(end[i] - begin)};
  }
  constexpr bool has_room_for(const base::sentence& p) const {
    return sizes.count < room.count && sizes.letters + p.length <= room.letters;
  }
  constexpr void push(const base::sentence& p) {
    for (char letter : p.view()) letters[sizes.letters++] = letter;
    end[sizes.count++] = static_cast<std::remove_reference_t<decltype(*end)>>(sizes.letters);
  }
};

/// For constant evaluation only; programs use the list that `trimmed` returns.
inline constexpr cause_sizes room_of_causes{1 << 12, 1 << 18};
using large_cause_list = cause_list<room_of_causes>;

/// Copies a list to arrays of minimal size: `trimmed<large.sizes>(large)`.
template <cause_sizes sizes, cause_sizes room>
constexpr cause_list<sizes> trimmed(const cause_list<room>& from) {
  cause_list<sizes> out{};
  out.sizes = sizes;
  for (int i = 0; i < sizes.count; ++i)
    out.end[i] = static_cast<std::remove_reference_t<decltype(*out.end)>>(from.end[i]);
  for (int i = 0; i < sizes.letters; ++i) out.letters[i] = from.letters[i];
  return out;
}

/// Returns a list with the single sentence that the captureless function `make` returns.
template <class Make>
constexpr auto only_cause(Make make) {
  constexpr base::sentence p = make();
  cause_list<cause_sizes{1, p.length}> one{};
  one.push(p);
  return one;
}

} // namespace kanexpr::derivation
