#pragma once

#include <kanexpr/animate/check_picture.hpp>
#include <kanexpr/animate/elements_of.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/function.hpp>

#include <array>
#include <span>

namespace kanexpr {

template <class System, class... Elements>
struct picture;

namespace animate {

template <class Picture>
struct valid_picture {
  static constexpr sentence mistake = Picture::mistake;
  static_assert(derivation::report<valid_picture>());
  static constexpr bool value = !static_cast<bool>(mistake);
};

} // namespace animate

/// Describes the appearance of a moving system: simple shapes on its frames and points, the paths of points,
/// and the ground.
///
///     using picture = kanexpr::picture<System, up<N::z>, ground<>, trace<P>,
///                                      show<rod<O, P, 0.02>>, show<sphere<P, 0.1>, colour<"#c0392b">>>;
template <class System_, class... Elements>
struct picture {
  using System = System_;
  static constexpr base::sentence mistake = animate::check_elements<Elements...>();
};

namespace animate {

/// The concatenated phrases of several elements, and the index at which the numbers of each element begin.
template <std::size_t... sizes>
struct layout {
  static constexpr std::size_t elements = sizeof...(sizes);
  phrases<(sizes + ... + 0)> all{};
  std::array<int, elements + 1> begin{};

  constexpr explicit layout(const phrases<sizes>&... lists) {
    const std::array<std::span<const phrase>, elements> given{lists...};
    for (std::size_t element = 0, next = 0; element < elements; ++element) {
      begin[element + 1] = begin[element];
      for (const phrase& p : given[element]) {
        begin[element + 1] += numbers_in(p);
        all[next++] = p;
      }
    }
  }
  constexpr int numbers() const { return begin[elements]; }
};

/// All numbers of a picture at one time, evaluated by a single function so that they share common
/// subexpressions: the time-varying ones, then the constant ones, then the rates.
template <class Picture>
struct numbers_of;

template <class Elements>
struct numbers_in_list;

template <class System, class... Elements>
struct numbers_of<picture<System, Elements...>> : numbers_in_list<elements_of<System, Elements...>> {};

template <class... Elements>
struct numbers_in_list<element_list<Elements...>> {
  static constexpr layout varying{Elements::varying...};
  static constexpr layout constant{Elements::constant...};
  static constexpr layout rates{Elements::rates...};
  static constexpr layout all{varying.all, constant.all, rates.all};
  static constexpr int first_constant = all.begin[1];
  static constexpr int first_rate = all.begin[2];
  static constexpr int count = all.numbers();
  static constexpr int rate_count = rates.numbers();
  static constexpr bool has_energies = (has_keyword<Elements>("plot_energies") || ...);
};

} // namespace animate

template <class Picture, animate::numbers_of<Picture> wanted>
struct derivation::requested<wanted> {
  static constexpr request value{.what = request::kind::expressions,
                                 .phrases = animate::numbers_of<Picture>::all.all,
                                 .whom = "the picture"};
};

} // namespace kanexpr
