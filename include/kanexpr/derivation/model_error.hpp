#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/text.hpp>

#include <utility>

/// Reports a mistake in a model to its author, as a sentence and as the only error of the compilation.
namespace kanexpr {

namespace derivation {

/// Whether there is a sentence to report, `Report::mistake`, that is not reported by `report_in_code`.
template <class Report>
constexpr bool has_message() {
  if constexpr (requires { Report::follows_from_unparsed; })
    return static_cast<bool>(Report::mistake) && !Report::follows_from_unparsed;
  else
    return static_cast<bool>(Report::mistake);
}

/// Returns the characters `begin` to `end` of a sentence as a template argument.
template <class Report, int begin, int end>
constexpr auto text_of() {
  text<static_cast<std::size_t>(end - begin + 1)> t;
  for (int i = begin; i < end; ++i) t.letters[i - begin] = Report::mistake.letters[i];
  t.letters[end - begin] = '\0'; // with a terminator, clang prints characters instead of numbers
  return t;
}

} // namespace derivation

#if __cpp_static_assert >= 202306L && __cplusplus > 202302L // C++26: the message may be computed

/// @internal Reports the sentence as the message of the assertion.
template <text sentence>
struct model_error {
  static_assert(sentence.view().empty(), sentence.view());
};

namespace derivation {

/// Stops the compilation with the sentence `Report::mistake`, if there is one. A repeated sentence is
/// reported only once.
template <class Report>
constexpr bool report() {
  if constexpr (has_message<Report>())
    return sizeof(model_error<text_of<Report, 0, Report::mistake.length>()>) != 0;
  else
    return true;
}

} // namespace derivation

#else

/// Never defined. Its template arguments are the sentence that the compiler prints.
template <text... sentence>
struct model_error;

namespace derivation {

// g++ prints character arrays in full. clang truncates them after about thirty characters, so for clang the
// sentence is split into pieces.
#ifdef __clang__
inline constexpr int longest_piece = 30;
#else
inline constexpr int longest_piece = base::sentence::capacity;
#endif

/// Returns the end of the piece of a message that starts at `begin`: at a space if possible, otherwise
/// within a word.
constexpr int piece_end(const base::sentence& p, int begin) {
  const int most = begin + longest_piece;
  if (most >= p.length) return p.length;
  int end = most;
  while (end > begin && p.letters[end] != ' ') --end;
  return end > begin ? end : most;
}

/// Returns the start of piece number `piece` of a sentence, or the length of the sentence if there is no such
/// piece.
constexpr int piece_begin(const base::sentence& p, int piece) {
  int begin = 0;
  for (; piece > 0 && begin < p.length; --piece) {
    begin = piece_end(p, begin);
    if (begin < p.length && p.letters[begin] == ' ') ++begin;
  }
  return begin;
}

template <class Report, int piece>
constexpr auto piece_of() {
  constexpr int begin = piece_begin(Report::mistake, piece);
  return text_of<Report, begin, piece_end(Report::mistake, begin)>();
}

constexpr int count_pieces(const base::sentence& p) {
  int pieces = 1;
  while (piece_begin(p, pieces) < p.length) ++pieces;
  return pieces;
}

// Overload resolution for `accept` completes its argument's class, which causes the error; the call itself
// remains valid, so there is no second error. Repeating the same sentence causes no further error either.
constexpr bool accept(const void*) { return true; }

template <text... sentence>
struct reported : model_error<sentence...> {};

/// For a whole system, the error is an invalid initialization of the system from a sentence, so that the
/// compiler shows where the system is defined.
template <class System, text... sentence>
struct reported_for {
#ifdef __clang__
  using error = decltype(System(std::declval<const model_error<sentence...>&>()));
#else
  using error = decltype(std::declval<System&>().operator=(std::declval<const model_error<sentence...>&>()));
#endif
};

/// Stops the compilation with the sentence `Report::mistake`, if there is one. The sentence concerns
/// `Report::system`, if that exists.
template <class Report>
constexpr bool report() {
  if constexpr (has_message<Report>())
    return []<int... index>(std::integer_sequence<int, index...>) {
      if constexpr (requires { typename Report::system; })
        return accept(
            static_cast<reported_for<typename Report::system, piece_of<Report, index>()...>*>(nullptr));
      else
        return accept(static_cast<reported<piece_of<Report, index>()...>*>(nullptr));
    }(std::make_integer_sequence<int, count_pieces(Report::mistake)>{});
  else
    return true;
}

} // namespace derivation

#endif

namespace derivation {

/// Compilers evaluate this attribute only during code generation, which they skip after an earlier error.
template <class System>
[[gnu::error("this system, or an entity in it, has no base class")]] void has_no_base_class() noexcept;

// The only call of this function, so that there is only one error.
template <class System>
[[gnu::noinline]] void reject_code() noexcept {
  has_no_base_class<System>();
}

/// Reports a system that depends on a type that did not parse, unless the compiler has reported an error.
template <class Report>
inline void report_in_code() noexcept {
  if constexpr (Report::follows_from_unparsed) reject_code<typename Report::system>();
}

} // namespace derivation

} // namespace kanexpr
