#pragma once

#include <kanexpr/describe/joints/joint_word.hpp>
#include <kanexpr/describe/load.hpp>

#include <cstddef>

namespace kanexpr {

/// An elastic mount between two bodies, given by joints, sections of beams or `frame_and_point`s:
/// `bushing<Arm, Chassis, kx, ky, kz, tx, ty, tz>`. The axes are those of the second. The stiffnesses along
/// the axes, in N/m, act on the displacement between the points; those about the axes, in N m/rad, exert the
/// torque t sin θ for a rotation by θ about one of them. The six dampings, which may follow, act on the
/// rates.
template <class Body, class Base, auto... stiffnesses_and_dampings>
struct bushing : describe::load_words {
  static constexpr describe::load_record load = [] {
    constexpr std::size_t given = sizeof...(stiffnesses_and_dampings);
    describe::load_record r;
    r.what = describe::load_word::bushing;
    r.word = "the bushing";
    r.once = true;
    r.fits = describe::arguments_of("bushing<Body, Base, six stiffnesses, six dampings>", given,
                                    given <= 6 ? 6 : 12, 12);
    r.frame = describe::parts_of<Body>::frame();
    r.point = describe::parts_of<Body>::point();
    r.other_frame = describe::parts_of<Base>::frame();
    r.other_point = describe::parts_of<Base>::point();
    constexpr bool is_all_zero = (describe::is_whole_zero(stiffnesses_and_dampings) && ...);
    if constexpr (is_all_zero)
      r.terms = describe::given_phrases<stiffnesses_and_dampings...>;
    else
      r.terms = describe::given_phrases_with_zeros<stiffnesses_and_dampings...>;
    r.terms_given = given;
    return r;
  }();
};

} // namespace kanexpr
