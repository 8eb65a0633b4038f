// The rows of elements that a model describes in the words of joints.
#pragma once

#include "elements.hpp"

#include <kanexpr/blocks.hpp>
#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/symbolic.hpp>

namespace elements_at_joints {

using namespace kanexpr;

struct N : inertial_ground<N> {};
struct Arm : pin<Arm, N, axis<N::z>, body<1.3, 0.3 * own::x + 0.1 * own::y, inertia<own, 0.2, 0.3, 0.4>>> {};
struct Slide : prismatic<Slide, Arm, axis<Arm::x + 0.5 * Arm::z>, at<0.4 * Arm::y>,
                         body<0.7, 0.2 * own::z, inertia<own, 0.1, 0.2, 0.15>>> {};
struct Stopped : pin<Stopped, N, axis<N::z>, stops<-0.3, 0.5, 50, 0.7, 0.4>,
                     body<1.3, 0.3 * own::x, inertia<own, 0.2, 0.3, 0.4>>> {};
struct Driven
    : pin<Driven, N, axis<N::z>, rotor<0.01, 12>, body<1.3, 0.3 * own::x, inertia<own, 0.2, 0.3, 0.4>>> {};

/// An arm that turns, with a body that slides along it.
template <class... Loads>
struct two_joints : kane_system<inertial<N>, joints<Arm, Slide>, loads<Loads...>> {};
struct with_stops : kane_system<inertial<N>, joints<Stopped>> {};
struct with_rotor : kane_system<inertial<N>, joints<Driven>> {};

} // namespace elements_at_joints

namespace elements {

/// An element that acts on one joint; it is measured by the coordinate and the speed of this joint, and by
/// the state variables.
template <class System>
mechanism_with_element at_joint(int joint) {
  kanexpr::model model = kanexpr::derive<System>();
  const mechanics::mechanism& m = model.mechanism();
  std::vector<expression> measured{m.coordinates[joint], m.speeds[joint]};
  for (int i = m.speeds_of_motion(); i < m.speeds.size(); ++i) measured.push_back(m.speeds[i]);
  return {std::move(model), measured};
}

/// An element that stores the energy ½ k z² of its first state variable, such as ½ L i² of a motor.
template <class System>
mechanism_with_element with_storage(int joint, double k) {
  mechanism_with_element made = at_joint<System>(joint);
  if (made.measured.size() < 3) return made; // a mistake, which is reported later
  made.stored = k / 2 * (made.measured[2] * made.measured[2]);
  return made;
}

inline std::vector<element> at_joints() {
  using namespace elements_at_joints;
  using n = nature;
  using values = const VectorXd&; // q, u and the state variables
  return {
      {"linear spring in a pin", n::conservative,
       [] { return at_joint<two_joints<linear_spring<Arm, 3, 0.4>>>(0); },
       [](values m) { return -3 * (m[0] - 0.4) * m[1]; }},
      {"cubic spring in a slide", n::conservative,
       [] { return at_joint<two_joints<cubic_spring<Slide, 3, 2, 0.4>>>(1); },
       [](values m) { return -(3 * (m[0] - 0.4) + 2 * std::pow(m[0] - 0.4, 3)) * m[1]; }},
      {"linear damper in a slide", n::dissipative,
       [] { return at_joint<two_joints<linear_damper<Slide, 3>>>(1); },
       [](values m) { return -3 * m[1] * m[1]; }},
      {"Coulomb friction in a pin", n::dissipative,
       [] { return at_joint<two_joints<friction<Arm, 6, coulomb_friction<0.4, 0.1>>>>(0); },
       [](values m) { return -6 * coulomb(m[1]) * m[1]; }},
      {"Stribeck friction in a slide", n::dissipative,
       [] { return at_joint<two_joints<friction<Slide, 6, stribeck_friction<0.6, 0.4, 0.1, 0.02>>>>(1); },
       [](values m) { return -6 * stribeck(m[1]) * m[1]; }},
      {"viscous friction in a slide", n::dissipative,
       [] { return at_joint<two_joints<friction<Slide, 6, viscous_friction<0.3>>>>(1); },
       [](values m) { return -6 * viscous(m[1]) * m[1]; }},
      {"LuGre's friction in a pin", n::dissipative,
       [] {
         return with_storage<two_joints<friction<Arm, 6, lugre_friction<0.6, 0.4, 0.5, 3, 0.5, 0.02, 0.1>>>>(
             0, 18);
       },
       [](values m) { return -6 * lugre(m[1], m[2]) * m[1]; }},
      {"Dahl's friction in a slide", n::dissipative,
       [] { return with_storage<two_joints<friction<Slide, 6, dahl_friction<0.4, 3, 0.1>>>>(1, 18); },
       [](values m) { return -6 * 3 * m[2] * m[1]; }},
      {"stops of a pin", n::dissipative, [] { return at_joint<with_stops>(0); },
       [](values m) {
         return -50 *
                (one_sided(m[0] - 0.5, 0.4) * hunt_and_crossley(0.7, m[1]) -
                 one_sided(-0.3 - m[0], 0.4) * hunt_and_crossley(0.7, -m[1])) *
                m[1];
       }},
      {"rotor of a pin", n::conservative, [] { return at_joint<with_rotor>(0); }, [](values) { return 0.0; }},
      {"DC motor of a pin", n::dissipative,
       [] { return with_storage<two_joints<dc_motor<Arm, 0.0, 2, 0.2, 0.3, 10, 0.02, 0.01>>>(0, 0.2); },
       [](values m) { return (10 * 0.3 * m[2] - 100 * 0.02 * m[1]) * m[1]; }},
      {"DC motor with a winding that heats", n::dissipative,
       [] {
         return with_storage<two_joints<dc_motor<Arm, 0.0, 2, 0.2, 0.3, 10, 0.02, 0.01, 0.004, 30, 1.5>>>(
             0, 0.2);
       },
       [](values m) { return (10 * 0.3 * m[2] - 100 * 0.02 * m[1]) * m[1]; }}};
}

} // namespace elements
