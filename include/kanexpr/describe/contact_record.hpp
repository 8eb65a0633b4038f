#pragma once

#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/loads/contact_shapes.hpp>
#include <kanexpr/mechanics/loads/friction_kind.hpp>

#include <string_view>

/// The records of contacts and of laws of friction.
namespace kanexpr::describe {

/// A law of friction. Values that it does not have are empty phrases.
struct friction_record {
  mechanics::friction_kind kind{};
  phrase sliding{}, sticking{}, slip_speed{}, viscous{};
  phrase stiffness{}, damping{}, stribeck_speed{}; ///< of bristles
  arguments fits{};
};

/// A contact. Values that it does not have are empty phrases.
struct contact_record {
  mechanics::contact_shapes shapes{};
  const point_record* point = nullptr;
  const point_record* other_point = nullptr;
  const frame_record* frame = nullptr;       ///< null if the first body is a point
  const frame_record* other_frame = nullptr; ///< null for a plane, whose frame is that of its normal
  phrase normal{}, axis{}, radius{}, other_radius{};
  phrase level{}; ///< of a surface
  phrase stiffness{}, exponent{}, width{}, damping{}, approach_speed{};
  double restitution = 1; ///< the damping follows from it if there is an approach speed
  const friction_record* friction = nullptr;
  phrase lever{}, rolling_rate{};           ///< of the resistance to rolling
  phrase spinning_lever{}, spinning_rate{}; ///< of the resistance to spinning
  phrase direction{}, ratio{};              ///< of directional friction
  arguments fits{};                         ///< of its words
  std::string_view mistake{};               ///< the end of a sentence, such as "has no elastic<...>"
};

} // namespace kanexpr::describe
