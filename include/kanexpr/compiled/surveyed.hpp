#pragma once

#include <kanexpr/derive/model_error.hpp>
#include <kanexpr/derive/survey.hpp>

namespace kanexpr::compiled {

/// A system's survey, formed once, with the end of the compilation if it holds a mistake.
template <class System>
struct surveyed {
  using system = System;
  static constexpr derivation::survey survey = derivation::survey_of<System>();
  static constexpr mechanics::problem mistake = survey.mistake;
  static constexpr bool follows_from_unparsed = survey.follows_from_unparsed;
  static_assert(derivation::tell<surveyed>());
};

template <class System>
inline constexpr const derivation::survey& survey_of = surveyed<System>::survey;

} // namespace kanexpr::compiled
