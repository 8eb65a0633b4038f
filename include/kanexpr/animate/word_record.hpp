#pragma once

#include <kanexpr/animate/numbers.hpp>

#include <array>
#include <string_view>

namespace kanexpr::animate {

/// An element of a picture as a plain value.
struct word_record {
  std::string_view word{};
  title name{};             ///< "sphere at P"
  std::string_view shape{}; ///< "sphere"; empty: shows no shape
  std::string_view file{};  ///< file of a mesh, or folder of files_in
  look looks{};
  placing placed_by = placing::place;
  bool has_axis = false; ///< if true, its axis precedes those of the frame
  int first_moving = 0;  ///< index of its first number among all numbers
  int first_still = 0;
  int still = 0;
  int first_rate = 0; ///< index among the rates
  int rates = 0;
};

template <class Word>
constexpr word_record record_of_word() {
  word_record r;
  r.word = Word::word;
  r.still = numbers_in(Word::still);
  r.rates = numbers_in(Word::rates);
  if constexpr (shown_word<Word>) {
    using attachment = typename Word::attachment;
    r.name = title_of<Word>();
    r.shape = kind_of<Word>();
    r.looks = Word::look;
    r.placed_by = attachment::placed_by;
    r.has_axis = requires { attachment::axis; };
    if constexpr (requires { attachment::file; }) r.file = attachment::file;
  }
  if constexpr (requires { Word::folder; }) r.file = Word::folder;
  return r;
}

template <class Picture>
struct records_of;

template <class System, class... Words>
struct records_of<picture<System, Words...>> {
  static constexpr std::array<word_record, sizeof...(Words)> list = [] {
    using numbers = numbers_of<picture<System, Words...>>;
    std::array<word_record, sizeof...(Words)> made{record_of_word<Words>()...};
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i].first_moving = numbers::moving.begin[i];
      made[i].first_still = numbers::first_still + numbers::still.begin[i];
      made[i].first_rate = numbers::rates.begin[i];
    }
    return made;
  }();
};

} // namespace kanexpr::animate
