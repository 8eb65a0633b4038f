#pragma once

#include <type_traits>

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

/// Whether an entity has words of a kind; true of one that has several.
template <class Entity, class Words>
inline constexpr bool has_words = std::is_base_of_v<Words, Entity>;

template <class Entity, class Words>
inline constexpr bool has_several = has_words<Entity, Words> && !std::is_convertible_v<Entity*, Words*>;

template <class Entity>
constexpr misfit find_misfit() {
  if constexpr (requires { sizeof(Entity); }) { // else it is described only later
    if (has_several<Entity, orientation_words>) return misfit::two_orientations;
    if (has_several<Entity, place_words>) return misfit::two_places;
    if (has_several<Entity, body_words>) return misfit::two_bodies;
    if (has_several<Entity, turning_words>) return misfit::two_angular_velocities;
    if (has_several<Entity, velocity_words>) return misfit::two_velocities;
    if (has_several<Entity, fixing_words>) return misfit::two_fixings;
    const bool is_point = has_words<Entity, place_words>;
    if (has_words<Entity, turning_words> && !has_words<Entity, orientation_words>)
      return misfit::angular_velocity_of_no_frame;
    if (has_words<Entity, velocity_words> && !is_point) return misfit::velocity_of_no_point;
    if (has_words<Entity, fixing_words> && !is_point) return misfit::fixing_of_no_point;
    if (has_words<Entity, inertia_words>) return misfit::inertia_beside;
  }
  return misfit::none;
}

} // namespace kanexpr::describe
