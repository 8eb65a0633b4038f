#pragma once

#include <kanexpr/describe/joints/joint_word.hpp>
#include <kanexpr/describe/path_load.hpp>

#include <cstddef>

namespace kanexpr {

/// Stops of a joint with one coordinate, among the words of the joint: `stops<-1.0, 2.0, k, c>` keeps the
/// coordinate between −1 and 2 as `stop<Joint, -1.0, 2.0, k, c>` does.
template <auto... ends_stiffness_damping_and_width>
struct stops {
  static constexpr describe::joint_word joint_word = describe::joint_word::stops;
  static constexpr std::size_t count = sizeof...(ends_stiffness_damping_and_width);
  template <class Joint>
  static constexpr const describe::load_record* load() {
    return &describe::load_of<stop<Joint, ends_stiffness_damping_and_width...>>;
  }
};

} // namespace kanexpr
