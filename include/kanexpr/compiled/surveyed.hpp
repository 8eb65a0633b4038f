#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/model_error.hpp>
#include <kanexpr/derivation/stages.hpp>
#include <kanexpr/derivation/survey.hpp>

namespace kanexpr::compiled {

/// The survey of a system, derived once. A mistake in the system causes a compile-time error.
template <class System>
struct surveyed {
  using system = System;
  static constexpr derivation::survey survey = derivation::stages_of<System>::constrained.known;
  static constexpr base::sentence mistake = derivation::stages_of<System>::constrained.mistake;
  static constexpr bool follows_from_unparsed =
      derivation::stages_of<System>::constrained.follows_from_unparsed;
  static_assert(derivation::report<surveyed>());
};

} // namespace kanexpr::compiled
