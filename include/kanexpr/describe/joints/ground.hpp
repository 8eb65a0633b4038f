#pragma once

#include <kanexpr/describe/point.hpp>

namespace kanexpr {

/// The inertial frame and a point fixed in it, as one type to which joints are attached: `struct Ground :
/// inertial_ground<Ground> {};`
template <class Self>
struct inertial_ground : describe::axes<Self>, describe::place_words, describe::ground_words {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.calls_itself = type_name<Self>();
    return r;
  }
  static constexpr describe::point_record place() {
    describe::point_record r;
    r.calls_itself = type_name<Self>();
    r.origin_of = &describe::frame_of<Self>;
    return r;
  }
};

} // namespace kanexpr
