#pragma once

#include <kanexpr/animate/picture.hpp>
#include <kanexpr/compiled/function.hpp>

#include <array>

namespace kanexpr {

namespace animate {

/// The concatenated phrases of several elements, and the index at which the numbers of each element begin.
template <std::size_t... sizes>
struct layout {
  static constexpr std::size_t words = sizeof...(sizes);
  phrases<(sizes + ... + 0)> all{};
  std::array<int, words + 1> begin{};

  constexpr explicit layout(const phrases<sizes>&... lists) {
    std::size_t word = 0, next = 0;
    (
        [&] {
          for (const phrase& p : lists) all[next++] = p;
          begin[word + 1] = begin[word] + numbers_in(lists);
          ++word;
        }(),
        ...);
  }
  constexpr int numbers() const { return begin[words]; }
};

/// All numbers of a picture at one time, evaluated by a single function so that they share common
/// subexpressions: the time-varying ones, then the constant ones, then the rates.
template <class Picture>
struct numbers_of;

template <class System, class... Words>
struct numbers_of<picture<System, Words...>> {
  static constexpr layout moving{Words::moving...};
  static constexpr layout still{Words::still...};
  static constexpr layout rates{Words::rates...};
  static constexpr layout all{moving.all, still.all, rates.all};
  static constexpr int first_still = all.begin[1];
  static constexpr int first_rate = all.begin[2];
  static constexpr int count = all.numbers();
  static constexpr int rate_count = rates.numbers();
};

} // namespace animate

template <class Picture, animate::numbers_of<Picture> wanted>
struct derivation::requested<wanted> {
  static constexpr request value{.what = request::kind::expressions,
                                 .phrases = animate::numbers_of<Picture>::all.all,
                                 .whom = "the picture"};
};

} // namespace kanexpr
