#pragma once

#include <kanexpr/describe/point.hpp>

namespace kanexpr {

/// A force that acts at a point: `force<P, F*N::x>`.
template <class Point, auto vector>
struct force {
  static constexpr describe::load_record load{describe::load_word::force, &describe::point_of<Point>, nullptr,
                                              describe::phrase_of<vector>};
};

/// A torque that acts on whatever is fixed in a frame: `torque<A, T*N::z>`.
template <class Frame, auto vector>
struct torque {
  static constexpr describe::load_record load{describe::load_word::torque, nullptr,
                                              &describe::frame_of<Frame>, describe::phrase_of<vector>};
};

/// Uniform gravity on every body, by the acceleration of free fall: `gravity<-g*N::z>`.
template <auto acceleration>
struct gravity {
  static constexpr describe::load_record load{describe::load_word::gravity, nullptr, nullptr,
                                              describe::phrase_of<acceleration>};
};

namespace describe {

template <class Load>
constexpr load_record record_load() {
  load_record r;
  if constexpr (requires { Load::load; }) {
    r = Load::load;
  } else {
    r.what = load_word::none;
    r.called = type_name<Load>();
  }
  return r;
}

template <class Load>
inline constexpr load_record load_of = record_load<Load>();

} // namespace describe

} // namespace kanexpr
