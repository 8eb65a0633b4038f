#pragma once

/// Detects words that an entity has twice or that belong to entities of a different kind. A second word of
/// the same kind makes name lookup ambiguous, so both would be ignored silently.
namespace kanexpr::describe {

// Base classes of the library's words, by which they are counted.
struct orientation_words {};
struct place_words {};
struct joint_words {};
struct ground_words {}; // an inertial frame and a point in it
struct body_words {};
struct angular_velocity_words {};
struct velocity_words {};
struct fixing_words {};
struct inertia_words {};
struct load_words {};
struct system_words {};
struct whole_systems {};

enum class misfit : unsigned char {
  none,
  hidden,
  name_of_another,
  frame_and_point,
  frame_and_body,
  point_and_body,
  entity_and_load,
  entity_and_system,
  two_orientations,
  two_places,
  two_joints,
  motion_beside_joint,
  two_bodies,
  two_loads,
  two_angular_velocities,
  two_velocities,
  two_fixings,
  angular_velocity_of_no_frame,
  velocity_of_no_point,
  fixing_of_no_point,
  inertia_beside,
  word_beside,
};

/// Whether a base class that appears once is private, as the bases of a class are by default.
template <class Words, class Entity>
constexpr bool hides(Entity* e) {
  using words = Words*;
  return requires { words(e); }; // a cast that ignores access control
}

/// Finds the misfit of a joint, which is both a frame and a point.
template <class Joint>
constexpr misfit find_misfit_of_joint() {
  constexpr Joint* j = nullptr;
  if constexpr (__is_base_of(joint_words, Joint) && !requires { static_cast<joint_words*>(j); })
    return hides<joint_words>(j) ? misfit::hidden : misfit::two_joints;
  if constexpr (!requires { static_cast<orientation_words*>(j); }) return misfit::two_orientations;
  if constexpr (!requires { static_cast<place_words*>(j); }) return misfit::two_places;
  if (__is_base_of(body_words, Joint)) return misfit::frame_and_body;
  if (__is_base_of(load_words, Joint)) return misfit::entity_and_load;
  if (__is_base_of(angular_velocity_words, Joint) || __is_base_of(velocity_words, Joint) ||
      __is_base_of(fixing_words, Joint))
    return misfit::motion_beside_joint;
  if (__is_base_of(inertia_words, Joint)) return misfit::inertia_beside;
  if (__is_base_of(whole_systems, Joint)) return misfit::entity_and_system;
  if (__is_base_of(system_words, Joint)) return misfit::word_beside;
  return misfit::none;
}

/// Finds the misfit of an entity or a load. It is evaluated for every entity, so it avoids templates, which
/// the compiler would have to store.
template <class Entity>
constexpr misfit find_misfit() {
  constexpr bool is_frame = __is_base_of(orientation_words, Entity);
  constexpr bool is_point = __is_base_of(place_words, Entity);
  constexpr bool is_body = __is_base_of(body_words, Entity);
  constexpr bool is_load = __is_base_of(load_words, Entity);
  constexpr bool turns = __is_base_of(angular_velocity_words, Entity),
                 moves = __is_base_of(velocity_words, Entity), is_fixed = __is_base_of(fixing_words, Entity);
  if constexpr (__is_base_of(joint_words, Entity) || __is_base_of(ground_words, Entity))
    return find_misfit_of_joint<Entity>();
  if (is_frame && is_point) return misfit::frame_and_point;
  if (is_frame && is_body) return misfit::frame_and_body;
  if (is_point && is_body) return misfit::point_and_body;
  if (is_load && (is_frame || is_point || is_body)) return misfit::entity_and_load;
  // a base class to which a pointer cannot be converted is ambiguous or private
  constexpr Entity* e = nullptr;
  if constexpr (is_frame && !requires { static_cast<orientation_words*>(e); })
    return hides<orientation_words>(e) ? misfit::hidden : misfit::two_orientations;
  if constexpr (is_point && !requires { static_cast<place_words*>(e); })
    return hides<place_words>(e) ? misfit::hidden : misfit::two_places;
  if constexpr (is_body && !requires { static_cast<body_words*>(e); })
    return hides<body_words>(e) ? misfit::hidden : misfit::two_bodies;
  if constexpr (is_load && !requires { static_cast<load_words*>(e); })
    return hides<load_words>(e) ? misfit::hidden : misfit::two_loads;
  if constexpr (turns && !requires { static_cast<angular_velocity_words*>(e); })
    return hides<angular_velocity_words>(e) ? misfit::hidden : misfit::two_angular_velocities;
  if constexpr (moves && !requires { static_cast<velocity_words*>(e); })
    return hides<velocity_words>(e) ? misfit::hidden : misfit::two_velocities;
  if constexpr (is_fixed && !requires { static_cast<fixing_words*>(e); })
    return hides<fixing_words>(e) ? misfit::hidden : misfit::two_fixings;
  if (turns && !is_frame) return misfit::angular_velocity_of_no_frame;
  if (moves && !is_point) return misfit::velocity_of_no_point;
  if (is_fixed && !is_point) return misfit::fixing_of_no_point;
  if (__is_base_of(inertia_words, Entity)) return misfit::inertia_beside;
  if (!is_frame && !is_point && !is_body && !is_load) return misfit::none;
  if (__is_base_of(whole_systems, Entity)) return misfit::entity_and_system;
  if (__is_base_of(system_words, Entity)) return misfit::word_beside;
  return misfit::none;
}

/// Whether a system, or a word of a system, has an additional base class that should be one of the system's
/// words.
template <class Told>
constexpr bool has_word_beside() {
  return __is_base_of(orientation_words, Told) || __is_base_of(place_words, Told) ||
         __is_base_of(body_words, Told) || __is_base_of(angular_velocity_words, Told) ||
         __is_base_of(velocity_words, Told) || __is_base_of(fixing_words, Told) ||
         __is_base_of(inertia_words, Told) || __is_base_of(load_words, Told);
}

} // namespace kanexpr::describe
