#pragma once

/// Words that an entity is given twice, or that belong to an entity of another kind. A second word of a kind
/// hides the first from those who look for it, so both would be lost without a word.
namespace kanexpr::describe {

// What the words of entities are derived from, so that they can be counted.
struct orientation_words {};
struct place_words {};
struct body_words {};
struct turning_words {};
struct velocity_words {};
struct fixing_words {};
struct inertia_words {};
struct system_words {};

enum class misfit : unsigned char {
  none,
  two_orientations,
  two_places,
  two_bodies,
  two_angular_velocities,
  two_velocities,
  two_fixings,
  angular_velocity_of_no_frame,
  velocity_of_no_point,
  fixing_of_no_point,
  inertia_beside,
};

/// Of an entity that is described. It is asked of each, so that it makes no use of templates, which the
/// compiler would have to keep.
template <class Entity>
constexpr misfit find_misfit() {
  constexpr bool is_frame = __is_base_of(orientation_words, Entity);
  constexpr bool is_point = __is_base_of(place_words, Entity);
  constexpr bool turns = __is_base_of(turning_words, Entity), moves = __is_base_of(velocity_words, Entity),
                 is_fixed = __is_base_of(fixing_words, Entity);
  // a base that is there, and that a pointer cannot be converted to, is there more than once
  constexpr Entity* e = nullptr;
  if (is_frame && !requires { static_cast<orientation_words*>(e); }) return misfit::two_orientations;
  if (is_point && !requires { static_cast<place_words*>(e); }) return misfit::two_places;
  if (__is_base_of(body_words, Entity) && !requires { static_cast<body_words*>(e); })
    return misfit::two_bodies;
  if (turns && !requires { static_cast<turning_words*>(e); }) return misfit::two_angular_velocities;
  if (moves && !requires { static_cast<velocity_words*>(e); }) return misfit::two_velocities;
  if (is_fixed && !requires { static_cast<fixing_words*>(e); }) return misfit::two_fixings;
  if (turns && !is_frame) return misfit::angular_velocity_of_no_frame;
  if (moves && !is_point) return misfit::velocity_of_no_point;
  if (is_fixed && !is_point) return misfit::fixing_of_no_point;
  if (__is_base_of(inertia_words, Entity)) return misfit::inertia_beside;
  return misfit::none;
}

/// Whether a word stands beside a system that should stand among those it is told.
template <class System>
constexpr bool has_word_beside() {
  return __is_base_of(system_words, System) || __is_base_of(orientation_words, System) ||
         __is_base_of(place_words, System) || __is_base_of(body_words, System) ||
         __is_base_of(turning_words, System) || __is_base_of(velocity_words, System) ||
         __is_base_of(fixing_words, System) || __is_base_of(inertia_words, System);
}

} // namespace kanexpr::describe
