#pragma once

#include <kanexpr/describe/joints/joint_word.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/symbol.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace kanexpr::describe {

/// The letter q or u, followed by a number if a body has several amplitudes.
template <char letter, std::size_t number, bool is_only>
inline constexpr auto numbered_letter = [] {
  constexpr std::size_t digits = is_only ? 0 : number < 10 ? 1 : 2;
  text<digits + 2> all;
  all.letters[0] = letter;
  if constexpr (digits == 1) all.letters[1] = static_cast<char>('0' + number);
  if constexpr (digits == 2) {
    all.letters[1] = static_cast<char>('0' + number / 10);
    all.letters[2] = static_cast<char>('0' + number % 10);
  }
  return all;
}();

template <class Body, std::size_t index>
inline constexpr auto amplitude_rate = dot(Body::template q<index>) == Body::template u<index>;

/// The symbols of the amplitudes of a body that deforms: q1_Body, q2_Body, …, or those of `by<…>` among its
/// words. `Body::coordinates_count` is the number of amplitudes; the body need not be complete before a
/// symbol is used.
template <class Body, class... Words>
struct amplitude_symbols {
private:
  using symbols_given = typename joint_word_among<joint_word::by, Words...>::type;

  static constexpr bool has_all_symbols() {
    if constexpr (requires { symbols_given::count; })
      return symbols_given::count == 2 * Body::coordinates_count;
    else
      return false;
  }
  static constexpr bool is_single() { return Body::coordinates_count == 1; }

public:
  /// The amplitude with the given index, and its rate.
  template <std::size_t index>
  static constexpr auto q = [] {
    if constexpr (has_all_symbols())
      return symbols_given::template symbol<index>;
    else
      return coordinate<joint_name<numbered_letter<'q', index + 1, is_single()>, Body>>{};
  }();
  template <std::size_t index>
  static constexpr auto u = [] {
    if constexpr (has_all_symbols())
      return symbols_given::template symbol<Body::coordinates_count + index>;
    else
      return speed<joint_name<numbered_letter<'u', index + 1, is_single()>, Body>>{};
  }();

protected:
  /// Whether `by<…>` has too few or too many symbols.
  static constexpr bool has_other_count() { return !std::is_void_v<symbols_given> && !has_all_symbols(); }

  /// Lists the symbols, and the kinematic equations q̇ = u, in the record of the body.
  template <class Record>
  static constexpr void list_symbols(Record& r) {
    list_symbols(r, std::make_index_sequence<Body::coordinates_count>());
  }

private:
  template <class Record, std::size_t... index>
  static constexpr void list_symbols(Record& r, std::index_sequence<index...>) {
    r.coordinates = list_of<phrase, &phrase_of<q<index>, Body>...>::all;
    r.speeds = list_of<phrase, &phrase_of<u<index>, Body>...>::all;
    r.kinematics = list_of<phrase, &phrase_of<amplitude_rate<Body, index>, Body>...>::all;
  }
};

} // namespace kanexpr::describe
