#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derive/model_error.hpp>
#include <kanexpr/derive/stages.hpp>
#include <kanexpr/derive/survey.hpp>

namespace kanexpr::compiled {

/// The survey of a system, derived once. A mistake in the system causes a compile-time error.
template <class System>
struct surveyed {
  using system = System;
  static constexpr deriving::survey survey = deriving::stages_of<System>::constrained.known;
  static constexpr mechanics::sentence mistake = deriving::stages_of<System>::constrained.mistake;
  static constexpr bool follows_from_unparsed =
      deriving::stages_of<System>::constrained.follows_from_unparsed;
  static_assert(deriving::report<surveyed>());
};

} // namespace kanexpr::compiled
