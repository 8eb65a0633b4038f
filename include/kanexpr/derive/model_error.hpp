#pragma once

#include <kanexpr/describe/text.hpp>
#include <kanexpr/mechanics/problem.hpp>

#include <utility>

/// How a mistake in a model reaches the person who made it: as the one error of the compilation, a sentence.
namespace kanexpr {

/// Never defined: its arguments are the sentence that the compiler prints.
template <text... sentence>
struct model_error;

namespace derivation {

#if __cpp_static_assert >= 202306L // C++26: the message may be computed

/// Ends the compilation with the sentence `Told::mistake`, if there is one.
template <class Told>
constexpr bool tell() {
  static_assert(!static_cast<bool>(Told::mistake), Told::mistake.view());
  return true;
}

#else

// g++ prints character arrays in full, clang cuts them after some thirty letters: there the sentence comes in pieces.
#ifdef __clang__
inline constexpr int longest_piece = 30;
#else
inline constexpr int longest_piece = mechanics::problem::capacity;
#endif

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

template <class Told, class Pieces>
struct told;
template <class Told, int... i>
struct told<Told, std::integer_sequence<int, i...>> : model_error<piece_of<Told, i>()...> {
  static constexpr bool value = true;
};

/// Ends the compilation with the sentence `Told::mistake`, if there is one.
template <class Told>
constexpr bool tell() {
  if constexpr (static_cast<bool>(Told::mistake))
    return sizeof(told<Told, std::make_integer_sequence<int, count_pieces<Told>()>>) != 0; // not run: one error
  else
    return true;
}

#endif

} // namespace derivation

} // namespace kanexpr
