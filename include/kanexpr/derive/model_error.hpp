#pragma once

#include <kanexpr/describe/text.hpp>
#include <kanexpr/mechanics/problem.hpp>

#include <utility>

namespace kanexpr {

/// Never defined: its arguments are the sentence that the compiler prints.
template <text... sentence>
struct model_error;

namespace derive {

// clang cuts character arrays after some forty letters, so the sentence is handed over in pieces.
inline constexpr int longest_piece = 34;

/// Where piece number `piece` of a sentence begins, cut at spaces; the length of the sentence for those behind its end.
constexpr int piece_begin(const mechanics::problem& p, int piece) {
  int begin = 0;
  for (; piece > 0 && begin < p.length; --piece) {
    int end = begin + longest_piece;
    if (end >= p.length) return p.length;
    while (end > begin + 1 && p.letters[end] != ' ') --end;
    begin = end + 1;
  }
  return begin < p.length ? begin : p.length;
}

template <class Told, int piece>
constexpr auto piece_of() {
  constexpr int begin = piece_begin(Told::mistake, piece), next = piece_begin(Told::mistake, piece + 1);
  constexpr int end = next == Told::mistake.length ? next : next - 1;
  text<static_cast<std::size_t>(end - begin + 1)> t;
  for (int i = begin; i < end; ++i) t.letters[i - begin] = Told::mistake.letters[i];
  return t;
}

template <class Told, int pieces = 1>
constexpr int count_pieces() {
  if constexpr (piece_begin(Told::mistake, pieces) == Told::mistake.length)
    return pieces;
  else
    return count_pieces<Told, pieces + 1>();
}

/// Ends the compilation with the sentence `Told::mistake`, if there is one.
template <class Told>
constexpr bool tell() {
  if constexpr (static_cast<bool>(Told::mistake))
    return []<int... i>(std::integer_sequence<int, i...>) {
      return sizeof(model_error<piece_of<Told, i>()...>) != 0;
    }(std::make_integer_sequence<int, count_pieces<Told>()>{});
  else
    return true;
}

} // namespace derive

} // namespace kanexpr
