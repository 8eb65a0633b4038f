#pragma once

#include <kanexpr/animate/check.hpp>
#include <kanexpr/base/sentence.hpp>
namespace kanexpr {

/// Describes the appearance of a moving system: simple shapes on its frames and points, the paths of points,
/// and the ground.
///
///     using picture = kanexpr::picture<System, up<N::z>, ground<>, trace<P>,
///                                      show<rod<O, P, 0.02>>, show<sphere<P, 0.1>, colour<"#c0392b">>>;
template <class System, class... Words>
struct picture;

namespace animate {

template <class Picture>
struct valid_picture {
  static constexpr sentence mistake = Picture::mistake;
  static_assert(derivation::report<valid_picture>());
  static constexpr bool value = !static_cast<bool>(mistake);
};

} // namespace animate

template <class System_, class... Words>
struct picture {
  using System = System_;
  static constexpr base::sentence mistake = animate::check_words<Words...>();
};

} // namespace kanexpr
