#pragma once

#include <kanexpr/derivation/survey.hpp>

namespace kanexpr::compiled {

/// Contains the survey of a system. The survey of a linked model is generated (see `linked_model.hpp`); all
/// others are derived (see `surveyed.hpp`).
template <class System>
struct surveyed;

template <class System>
inline constexpr const derivation::survey& survey_of = surveyed<System>::survey;

} // namespace kanexpr::compiled
