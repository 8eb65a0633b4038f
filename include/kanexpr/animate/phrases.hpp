#pragma once

#include <kanexpr/describe/motion.hpp>
#include <kanexpr/describe/record.hpp>

#include <array>

/// The scalars and vectors of a model that a picture evaluates.
namespace kanexpr::animate {

using describe::phrase;
using describe::shape;

template <std::size_t size>
using phrases = std::array<phrase, size>;

constexpr int numbers_in(const phrase& p) { return p.kind == shape::vector ? 3 : 1; }

template <std::size_t size>
constexpr int numbers_in(const phrases<size>& list) {
  int sum = 0;
  for (const phrase& p : list) sum += numbers_in(p);
  return sum;
}

template <auto... expressions>
inline constexpr phrases<sizeof...(expressions)> phrases_of{describe::phrase_of<expressions>...};

/// The position of a point relative to its origin.
template <class Point>
inline constexpr phrase place = describe::phrase_of<describe::motion_of(
    describe::token_kind::position, &describe::point_of<Point>, !is_known_to_all_files<Point>)>;

/// Two axes of a frame; the third is their cross product.
template <class Frame>
inline constexpr phrase x_of =
    describe::phrase_of<describe::basis(&describe::frame_of<Frame>, 0, !is_known_to_all_files<Frame>)>;
template <class Frame>
inline constexpr phrase y_of =
    describe::phrase_of<describe::basis(&describe::frame_of<Frame>, 1, !is_known_to_all_files<Frame>)>;

} // namespace kanexpr::animate
