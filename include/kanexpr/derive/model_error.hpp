#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/text.hpp>

#include <utility>

/// Reports a mistake in a model to its author, as a sentence and as the only error of the compilation.
namespace kanexpr {

namespace deriving {

/// Whether there is a sentence to report, `Told::mistake`, that is not reported by `tell_in_code`.
template <class Told>
constexpr bool is_told() {
  if constexpr (requires { Told::follows_from_unparsed; })
    return static_cast<bool>(Told::mistake) && !Told::follows_from_unparsed;
  else
    return static_cast<bool>(Told::mistake);
}

/// Returns the characters `begin` to `end` of a sentence as a template argument.
template <class Told, int begin, int end>
constexpr auto text_of() {
  text<static_cast<std::size_t>(end - begin + 1)> t;
  for (int i = begin; i < end; ++i) t.letters[i - begin] = Told::mistake.letters[i];
  t.letters[end - begin] = '\0'; // with a terminator, clang prints characters instead of numbers
  return t;
}

} // namespace deriving

#if __cpp_static_assert >= 202306L && __cplusplus > 202302L // C++26: the message may be computed

/// Reports the sentence as the message of the assertion.
template <text sentence>
struct model_error {
  static_assert(sentence.view().empty(), sentence.view());
};

namespace deriving {

/// Stops the compilation with the sentence `Told::mistake`, if there is one. A repeated sentence is reported
/// only once.
template <class Told>
constexpr bool tell() {
  if constexpr (is_told<Told>())
    return sizeof(model_error<text_of<Told, 0, Told::mistake.length>()>) != 0;
  else
    return true;
}

} // namespace deriving

#else

/// Never defined. Its template arguments are the sentence that the compiler prints.
template <text... sentence>
struct model_error;

namespace deriving {

// g++ prints character arrays in full. clang truncates them after about thirty characters, so for clang the
// sentence is split into pieces.
#ifdef __clang__
inline constexpr int longest_piece = 30;
#else
inline constexpr int longest_piece = mechanics::sentence::capacity;
#endif

/// Returns the end of the piece of a sentence that starts at `begin`: at a space if possible, otherwise
/// within a word.
constexpr int piece_end(const mechanics::sentence& p, int begin) {
  const int most = begin + longest_piece;
  if (most >= p.length) return p.length;
  int end = most;
  while (end > begin && p.letters[end] != ' ') --end;
  return end > begin ? end : most;
}

/// Returns the start of piece number `piece` of a sentence, or the length of the sentence if there is no such
/// piece.
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

// Overload resolution for `shown` completes its argument's class, which is the error; the call itself remains
// valid, so there is no second error. Repeating the same sentence gives no further error either.
constexpr bool shown(const void*) { return true; }

template <text... sentence>
struct told : model_error<sentence...> {};

/// For a whole system, the error is an invalid initialization of the system from a sentence, so that the
/// compiler shows where the system is defined.
template <class System, text... sentence>
struct told_of {
#ifdef __clang__
  using error = decltype(System(std::declval<const model_error<sentence...>&>()));
#else
  using error = decltype(std::declval<System&>().operator=(std::declval<const model_error<sentence...>&>()));
#endif
};

/// Stops the compilation with the sentence `Told::mistake`, if there is one. The sentence concerns
/// `Told::system`, if that exists.
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

/// Compilers evaluate this attribute only during code generation, which they skip after an earlier error.
template <class System>
[[gnu::error("this system, or an entity in it, has no base class")]] void derived_from_nothing() noexcept;

// The only call of this function, so that there is only one error.
template <class System>
[[gnu::noinline]] void refuse_code() noexcept {
  derived_from_nothing<System>();
}

/// Reports a system that depends on a type that did not parse, unless the compiler has reported an error.
template <class Told>
inline void tell_in_code() noexcept {
  if constexpr (Told::follows_from_unparsed) refuse_code<typename Told::system>();
}

} // namespace deriving

} // namespace kanexpr
