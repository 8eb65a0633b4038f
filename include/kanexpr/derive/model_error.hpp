#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/text.hpp>

#include <utility>

/// How a mistake in a model reaches the person who made it: as the one error of the compilation, a sentence.
namespace kanexpr {

namespace deriving {

/// Whether there is a sentence to report, `Told::mistake`, and not left to `tell_in_code`.
template <class Told>
constexpr bool is_told() {
  if constexpr (requires { Told::follows_from_unparsed; })
    return static_cast<bool>(Told::mistake) && !Told::follows_from_unparsed;
  else
    return static_cast<bool>(Told::mistake);
}

/// Letters `begin` to `end` of a sentence as a template argument.
template <class Told, int begin, int end>
constexpr auto text_of() {
  text<static_cast<std::size_t>(end - begin + 1)> t;
  for (int i = begin; i < end; ++i) t.letters[i - begin] = Told::mistake.letters[i];
  t.letters[end - begin] = '\0'; // clang prints letters, not numbers, where the end is written too
  return t;
}

} // namespace deriving

#if __cpp_static_assert >= 202306L && __cplusplus > 202302L // C++26: the message may be computed

/// The sentence is the message.
template <text sentence>
struct model_error {
  static_assert(sentence.view().empty(), sentence.view());
};

namespace deriving {

/// Ends the compilation with the sentence `Told::mistake`, if there is one; only once where it is reported
/// again.
template <class Told>
constexpr bool tell() {
  if constexpr (is_told<Told>())
    return sizeof(model_error<text_of<Told, 0, Told::mistake.length>()>) != 0;
  else
    return true;
}

} // namespace deriving

#else

/// Never defined: its arguments are the sentence that the compiler prints.
template <text... sentence>
struct model_error;

namespace deriving {

// g++ prints character arrays in full, clang cuts them after some thirty letters: there the sentence comes in
// pieces.
#ifdef __clang__
inline constexpr int longest_piece = 30;
#else
inline constexpr int longest_piece = mechanics::sentence::capacity;
#endif

/// Where the piece of a sentence ends that begins at `begin`: at a space, if there is one, else in a word.
constexpr int piece_end(const mechanics::sentence& p, int begin) {
  const int most = begin + longest_piece;
  if (most >= p.length) return p.length;
  int end = most;
  while (end > begin && p.letters[end] != ' ') --end;
  return end > begin ? end : most;
}

/// Where piece number `piece` of a sentence begins; the length of the sentence for those behind its end.
constexpr int piece_begin(const mechanics::sentence& p, int piece) {
  int begin = 0;
  for (; piece > 0 && begin < p.length; --piece) {
    begin = piece_end(p, begin);
    if (begin < p.length && p.letters[begin] == ' ') ++begin;
  }
  return begin;
}

template <class Told, int piece>
constexpr auto piece_of() {
  constexpr int begin = piece_begin(Told::mistake, piece);
  return text_of<Told, begin, piece_end(Told::mistake, begin)>();
}

constexpr int count_pieces(const mechanics::sentence& p) {
  int pieces = 1;
  while (piece_begin(p, pieces) < p.length) ++pieces;
  return pieces;
}

// The look-up of `shown` completes its argument's class, which is the error; the call itself stays sound, so
// that there is no second one. Nor is there where the same sentence is reported again.
constexpr bool shown(const void*) { return true; }

template <text... sentence>
struct told : model_error<sentence...> {};

/// Of a whole system: what cannot be made of a sentence, so that the compiler shows where the system is
/// written.
template <class System, text... sentence>
struct told_of {
#ifdef __clang__
  using error = decltype(System(std::declval<const model_error<sentence...>&>()));
#else
  using error = decltype(std::declval<System&>().operator=(std::declval<const model_error<sentence...>&>()));
#endif
};

/// Ends the compilation with the sentence `Told::mistake`, if there is one. It is about `Told::system`, if
/// there is that.
template <class Told>
constexpr bool tell() {
  if constexpr (is_told<Told>())
    return []<int... index>(std::integer_sequence<int, index...>) {
      if constexpr (requires { typename Told::system; })
        return shown(static_cast<told_of<typename Told::system, piece_of<Told, index>()...>*>(nullptr));
      else
        return shown(static_cast<told<piece_of<Told, index>()...>*>(nullptr));
    }(std::make_integer_sequence<int, count_pieces(Told::mistake)>{});
  else
    return true;
}

} // namespace deriving

#endif

namespace deriving {

/// Compilers look at this attribute when they make code, which they do where there was no error before.
template <class System>
[[gnu::error("this system, or an entity in it, is derived from nothing")]] void
derived_from_nothing() noexcept;

// One call, so that there is one error.
template <class System>
[[gnu::noinline]] void refuse_code() noexcept {
  derived_from_nothing<System>();
}

/// Tells of a system that depends on what did not parse, unless the compiler has reported its error.
template <class Told>
inline void tell_in_code() noexcept {
  if constexpr (Told::follows_from_unparsed) refuse_code<typename Told::system>();
}

} // namespace deriving

} // namespace kanexpr
