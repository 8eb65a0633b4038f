#pragma once

#include <kanexpr/describe/load.hpp>
#include <kanexpr/describe/pathway.hpp>

#include <cstddef>
#include <string_view>

/// Loads along pathways. A positive tension shortens the pathway, as in a stretched cable. A joint with one
/// coordinate is a pathway whose length is this coordinate.
namespace kanexpr {

namespace describe {

/// A load along a pathway; `terms` are the arguments of its law.
template <class Path>
constexpr load_record load_along(load_word what, std::string_view word, const arguments& fits,
                                 const phrase* terms, std::size_t given) {
  load_record r;
  r.what = what;
  r.word = word;
  r.fits = fits;
  r.path = &path_of<Path>;
  r.terms = terms;
  r.terms_given = static_cast<int>(given);
  r.known_by = path_of<Path>.length;
  r.once = true;
  if (path_of<Path>.ends_at_points()) {
    r.point = &path_of<Path>.points[0];
    r.other_point = &path_of<Path>.points[path_of<Path>.points.size - 1];
  }
  return r;
}

} // namespace describe

/// A given tension in a pathway: `force_along<straight<P, Q>, F>`. A positive value pulls the ends together.
template <class Path, auto... tension>
struct force_along : describe::load_words {
  static constexpr describe::load_record load = [] {
    describe::load_record r = describe::load_along<Path>(
        describe::load_word::path_force, "the force",
        describe::arguments_of("force_along<Path, tension>", sizeof...(tension), 1), nullptr, 0);
    r.value = describe::given_phrases<tension...>[0];
    return r;
  }();
};

/// A linear spring along a pathway of length l, with the tension k (l − l₀): `linear_spring<Path, k, l0>`.
template <class Path, auto... stiffness_and_length>
struct linear_spring : describe::load_words {
  static constexpr describe::load_record load = describe::load_along<Path>(
      describe::load_word::path_spring, "the linear spring",
      describe::arguments_of("linear_spring<Path, stiffness, natural length>",
                             sizeof...(stiffness_and_length), 1, 2),
      describe::given_phrases<stiffness_and_length...>, sizeof...(stiffness_and_length));
};

/// A spring of Duffing along a pathway of length l, with the tension k x + k₃ x³ for x = l − l₀:
/// `cubic_spring<Path, k, k3, l0>`.
template <class Path, auto... stiffnesses_and_length>
struct cubic_spring : describe::load_words {
  static constexpr describe::load_record load = describe::load_along<Path>(
      describe::load_word::path_cubic_spring, "the cubic spring",
      describe::arguments_of("cubic_spring<Path, stiffness, cubic stiffness, natural length>",
                             sizeof...(stiffnesses_and_length), 2, 3),
      describe::given_phrases<stiffnesses_and_length...>, sizeof...(stiffnesses_and_length));
};

/// A linear damper along a pathway, with the tension c dl/dt: `linear_damper<Path, c>`.
template <class Path, auto... damping>
struct linear_damper : describe::load_words {
  static constexpr describe::load_record load = [] {
    describe::load_record r = describe::load_along<Path>(
        describe::load_word::path_damper, "the linear damper",
        describe::arguments_of("linear_damper<Path, damping>", sizeof...(damping), 1), nullptr, 0);
    r.value = describe::given_phrases<damping...>[0];
    return r;
  }();
};

/// Stops at the least and the greatest length of a pathway: `stop<Path, least, greatest, k, c>`. Beyond an
/// end by x, the force is k g(x) (1 + c ẋ), which acts against x and never in the opposite sense: g(x) is
/// zero for x ≤ 0 and x − w/2 for x ≥ w, with continuous second derivatives, and the factor of Hunt &
/// Crossley (1975) is rounded to zero for fast separation. The stop creates no energy, whatever the motion.
/// The width w is the last argument; the default is a thousandth of the distance between the ends. The unit
/// of the damping c is that of 1/ẋ.
template <class Path, auto... ends_stiffness_damping_and_width>
struct stop : describe::load_words {
  static constexpr describe::load_record load = describe::load_along<Path>(
      describe::load_word::path_stop, "the stop",
      describe::arguments_of("stop<Path, least, greatest, stiffness, damping, width>",
                             sizeof...(ends_stiffness_damping_and_width), 4, 5),
      describe::given_phrases<ends_stiffness_damping_and_width...>,
      sizeof...(ends_stiffness_damping_and_width));
};

} // namespace kanexpr
