#pragma once

/// Detects words that an entity has twice or that belong to entities of a different kind. A second word of
/// the same kind makes name lookup ambiguous, so both would be ignored silently.
namespace kanexpr::describe {

// Base classes that mark the kinds of words, so that the words of an entity can be counted.
struct orientation_words {};
struct place_words {};
struct joint_words {};
struct ground_words {};               // an inertial frame and a point in it
struct section_words {};              // a frame and a point of a beam
struct node_words : section_words {}; // a frame and a point of a flexible body
struct body_words {};
struct angular_velocity_words {};
struct velocity_words {};
struct fixing_words {};
struct inertia_words {};
struct load_words {};
struct block_words {};
struct system_words {};
struct whole_systems {};

/// A sentence with @ in place of the entity's name; null if there is no conflict.
using base_conflict = const char*;

inline constexpr base_conflict
    two_orientations = "frame @ has two orientations",
    two_places = "point @ has two positions",
    frame_and_body = "@ is described both as a frame and as a body; give each its own name",
    load_as_base = "a load is a base class of @; list it in the system's loads<...>",
    inertia_as_base = "an inertia is a base class of @; it belongs in rigid_body<...>",
    system_as_base = "@ is described both as part of a system and as a whole system; give each its own name",
    word_as_base = "a word of the system is a base class of @; list it among the words of the system";

/// Whether a base class that appears once is private, as the bases of a class are by default.
template <class Words, class Entity>
constexpr bool inherits_privately(Entity* e) {
  using words = Words*;
  return requires { words(e); }; // a cast that ignores access control
}

/// Returns the conflict for a base class to which a pointer cannot be converted because it is private or
/// ambiguous.
template <class Words, class Entity>
constexpr base_conflict private_or(base_conflict twice, Entity* e) {
  return inherits_privately<Words>(e) ? "@ inherits privately; declare it as a struct" : twice;
}

/// Finds the conflict in a joint or another entity that is both a frame and a point.
template <class Joint>
constexpr base_conflict find_base_conflict_of_joint() {
  constexpr Joint* j = nullptr;
  if constexpr (__is_base_of(joint_words, Joint) && !requires { static_cast<joint_words*>(j); })
    return private_or<joint_words>("@ is declared as two joints; give each its own name", j);
  if constexpr (!requires { static_cast<orientation_words*>(j); }) return two_orientations;
  if constexpr (!requires { static_cast<place_words*>(j); }) return two_places;
  if (__is_base_of(body_words, Joint)) return frame_and_body;
  if (__is_base_of(load_words, Joint)) return load_as_base;
  if (__is_base_of(angular_velocity_words, Joint) || __is_base_of(velocity_words, Joint) ||
      __is_base_of(fixing_words, Joint))
    return __is_base_of(node_words, Joint) ? "a motion is declared for node @, which moves with its body"
           : __is_base_of(section_words, Joint)
               ? "a motion is declared for section @, which moves with its beam"
               : "a motion is declared for joint @, whose kind determines how it moves";
  if (__is_base_of(inertia_words, Joint)) return inertia_as_base;
  if (__is_base_of(whole_systems, Joint)) return system_as_base;
  if (__is_base_of(system_words, Joint)) return word_as_base;
  return nullptr;
}

/// Finds the conflict in an entity or a load. It is evaluated for every entity, so it avoids templates, which
/// the compiler would have to store.
template <class Entity>
constexpr base_conflict find_base_conflict() {
  constexpr bool is_frame = __is_base_of(orientation_words, Entity);
  constexpr bool is_point = __is_base_of(place_words, Entity);
  constexpr bool is_body = __is_base_of(body_words, Entity);
  constexpr bool is_load = __is_base_of(load_words, Entity);
  constexpr bool turns = __is_base_of(angular_velocity_words, Entity),
                 moves = __is_base_of(velocity_words, Entity), is_fixed = __is_base_of(fixing_words, Entity);
  if constexpr (__is_base_of(joint_words, Entity) || __is_base_of(ground_words, Entity) ||
                __is_base_of(section_words, Entity))
    return find_base_conflict_of_joint<Entity>();
  if (is_frame && is_point) return "@ is described both as a frame and as a point; give each its own name";
  if (is_frame && is_body) return frame_and_body;
  if (is_point && is_body) return "@ is described both as a point and as a body; give each its own name";
  if (is_load && (is_frame || is_point || is_body)) return load_as_base;
  constexpr Entity* e = nullptr;
  if constexpr (is_frame && !requires { static_cast<orientation_words*>(e); })
    return private_or<orientation_words>(two_orientations, e);
  if constexpr (is_point && !requires { static_cast<place_words*>(e); })
    return private_or<place_words>(two_places, e);
  if constexpr (is_body && !requires { static_cast<body_words*>(e); })
    return private_or<body_words>("body @ is described twice", e);
  if constexpr (is_load && !requires { static_cast<load_words*>(e); })
    return private_or<load_words>("@ is declared as two loads; give each its own name", e);
  if constexpr (turns && !requires { static_cast<angular_velocity_words*>(e); })
    return private_or<angular_velocity_words>("frame @ has two angular velocities", e);
  if constexpr (moves && !requires { static_cast<velocity_words*>(e); })
    return private_or<velocity_words>("point @ has two velocities", e);
  if constexpr (is_fixed && !requires { static_cast<fixing_words*>(e); })
    return private_or<fixing_words>("point @ is fixed in two frames", e);
  if (turns && !is_frame) return "angular_velocity<...> is a base class of @, which is not a frame";
  if (moves && !is_point) return "velocity<...> is a base class of @, which is not a point";
  if (is_fixed && !is_point) return "fixed_in<...> is a base class of @, which is not a point";
  if (__is_base_of(inertia_words, Entity)) return inertia_as_base;
  if (!is_frame && !is_point && !is_body && !is_load) return nullptr;
  if (__is_base_of(whole_systems, Entity)) return system_as_base;
  if (__is_base_of(system_words, Entity)) return word_as_base;
  return nullptr;
}

/// Whether a system, or a word of a system, has an additional base class that should be one of the system's
/// words.
template <class Type>
consteval bool has_misplaced_word() {
  return __is_base_of(orientation_words, Type) || __is_base_of(place_words, Type) ||
         __is_base_of(body_words, Type) || __is_base_of(angular_velocity_words, Type) ||
         __is_base_of(velocity_words, Type) || __is_base_of(fixing_words, Type) ||
         __is_base_of(inertia_words, Type) || __is_base_of(load_words, Type);
}

} // namespace kanexpr::describe
