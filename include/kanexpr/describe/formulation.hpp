#pragma once

#include <kanexpr/describe/frame.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/symbolic/operation_weights.hpp>

#include <concepts>
#include <string_view>

namespace kanexpr {

/// What operations cost on a target, in any unit: `operation_weights{.fused = 1}`.
using symbolic::operation_weights;

namespace describe {

/// The equations of the bodies that move with a frame.
struct frame_formulation_record {
  const frame_record* frame = nullptr;
  const frame_record* axes = nullptr;
  bool about_the_center = false;
};

/// How the equations of a system are formed.
struct formulation_record {
  mechanics::solution solved_by = mechanics::solution::cheapest;
  mechanics::internal_speeds speeds = mechanics::internal_speeds::given;
  listing<frame_formulation_record> frames{};
  operation_weights weights{};
  std::string_view stranger{}; ///< a type in the list that is no part of a formulation
};

/// A part of `formulation<...>`.
struct formulation_parts {
  static constexpr frame_formulation_record of_frame{}; ///< of no frame
  static constexpr void add_to(formulation_record&) {}
};

template <class Part>
inline constexpr frame_formulation_record frame_formulation_of = [] {
  frame_formulation_record of_no_frame;
  if constexpr (std::derived_from<Part, formulation_parts>) return Part::of_frame;
  return of_no_frame;
}();

template <class Part>
constexpr void add_part(formulation_record& r) {
  if constexpr (std::derived_from<Part, formulation_parts>)
    Part::add_to(r);
  else
    r.stranger = type_name<Part>();
}

template <class... Parts>
inline constexpr formulation_record formulation_of = [] {
  formulation_record r;
  (add_part<Parts>(r), ...);
  r.frames = list_of<frame_formulation_record, &frame_formulation_of<Parts>...>::all;
  return r;
}();

} // namespace describe

/// How the equations of motion are formed, where this is not left to the library:
/// `formulation<written_in<Arm, Shoulder>, by_elimination>`. The motion does not depend on it, but the number
/// of operations does; `explain` finds the cheapest form. Without this word, the library chooses by rules,
/// and counts only where it is cheap to do so.
template <class... Parts>
struct formulation : describe::system_words {
  static constexpr std::string_view word = "formulation";
  static constexpr void add_to(describe::system_record& r) {
    r.formulation = &describe::formulation_of<Parts...>;
  }
};

/// In `formulation<...>`: the equations of all bodies that move with `Frame` are written in the axes of the
/// frame `Axes`.
template <class Frame, class Axes>
struct written_in : describe::formulation_parts {
  static constexpr describe::frame_formulation_record of_frame{&describe::frame_of<Frame>,
                                                               &describe::frame_of<Axes>, false};
};

/// In `formulation<...>`: the equations of the bodies that move with `Frame` are written about their mass
/// centers instead of the joint that carries them.
template <class Frame>
struct about_mass_center : describe::formulation_parts {
  static constexpr describe::frame_formulation_record of_frame{&describe::frame_of<Frame>, nullptr, true};
};

/// In `formulation<...>`: u̇ follows from M u̇ = f by elimination, M = LᵀDL.
struct by_elimination : describe::formulation_parts {
  static constexpr void add_to(describe::formulation_record& r) {
    r.solved_by = mechanics::solution::elimination;
  }
};

/// In `formulation<...>`: u̇ of a tree of rigid bodies follows from articulated bodies (Featherstone 2008,
/// chapter 7), whose operations grow in proportion to the length of a chain.
struct by_articulated_bodies : describe::formulation_parts {
  static constexpr void add_to(describe::formulation_record& r) {
    r.solved_by = mechanics::solution::articulated_bodies;
  }
};

/// In `formulation<...>`: the equations of bodies that rotate about parallel axes of the ground are formed
/// for their angular velocities in the ground, and u̇ is found from the rates of these. The speeds of the
/// model remain the same.
struct in_absolute_speeds : describe::formulation_parts {
  static constexpr void add_to(describe::formulation_record& r) {
    r.speeds = mechanics::internal_speeds::absolute;
  }
};

/// In `formulation<...>`: what operations cost on the target, for the choices that the library makes:
/// `weighted_by<operation_weights{.fused = 1}>`.
template <operation_weights weights>
struct weighted_by : describe::formulation_parts {
  static constexpr void add_to(describe::formulation_record& r) { r.weights = weights; }
};

} // namespace kanexpr
