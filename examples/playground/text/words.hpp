#pragma once

#include <span>
#include <string_view>

namespace playground {

/// A word that begins a line, and the rest of the line as a pattern. In a pattern, `{…}` is a slot, `[…]` an
/// optional part, and everything else is written as it stands. The slots:
/// - `name`, `coordinate`, `speed`: a new name; `frame`, `point`, `symbol`: a name that exists
/// - `scalar`, `vector`: an expression; `scalars`, `vectors`, `symbols`: a list with commas
/// - `number`: an expression of numbers; `letters`: axes of rotations, such as zxz
struct word {
  std::string_view called{};
  std::string_view pattern{};
  std::string_view group{}; ///< under which the page offers it
  std::string_view meaning{};
  bool repeats = false; ///< whether a comma begins another one: `parameter m = 1, l = 2`
};

inline constexpr word words[]{
    {"inertial", "{name}", "", "the name of the inertial frame; without this line it is N"},
    {"parameter", "{name} [= {number}]", "Symbol", "a constant and its value", true},
    {"input", "{name} [= {number}]", "Symbol", "a force, torque or other input and its value", true},
    {"coordinate", "{name} [= {number}]", "Symbol", "a generalized coordinate and its initial value", true},
    {"speed", "{name} [= {number}]", "Symbol", "a generalized speed and its initial value", true},
    {"kinematics", "{scalar} = {scalar}", "Symbol", "a kinematic differential equation, such as dot(q) = u"},
    {"pin", "{name} on {frame} about {vector} by {coordinate} [= {number}] , {speed} [= {number}]", "Joint",
     "a frame that turns about an axis by a coordinate, whose rate is a speed"},
    {"slider", "{name} from {point} along {vector} by {coordinate} [= {number}] , {speed} [= {number}]",
     "Joint", "a point that slides along a unit vector by a coordinate, whose rate is a speed"},
    {"rotated", "{name} from {frame} by {scalar} about {vector}", "Joint", "a frame turned by an angle"},
    {"body_fixed", "{name} from {frame} by {letters} : {scalars}", "Joint",
     "a frame turned by three angles about its own axes"},
    {"space_fixed", "{name} from {frame} by {letters} : {scalars}", "Joint",
     "a frame turned by three angles about the axes of the other frame"},
    {"angular_velocity", "{frame} in {frame} : {vector}", "Joint",
     "the angular velocity of a frame in terms of the speeds"},
    {"kinematics_of", "{frame} in {frame}", "Joint",
     "equates a declared angular velocity with the derived one"},
    {"origin", "{name}", "Joint", "a point fixed in the inertial frame"},
    {"offset", "{name} from {point} by {vector}", "Joint", "a point at a distance from another one"},
    {"fixed", "{point} in {frame}", "Joint", "a point that moves with a frame as its parent does"},
    {"loop", "{point} to {point} along {vectors}", "Joint",
     "closes a loop: the points coincide along directions"},
    {"no_slip", "{point} along {vectors}", "Joint", "a point without velocity along directions"},
    {"configuration_constraint", "{scalar} = {scalar}", "Joint", "an equation of the coordinates"},
    {"velocity_constraint", "{scalar} = {scalar}", "Joint", "an equation that is linear in the speeds"},
    {"dependent", "{symbols}", "Joint", "the coordinates and speeds that the constraints determine"},
    {"particle", "{name} at {point} mass {scalar}", "Body", "a point mass"},
    {"rigid_body", "{name} at {point} in {frame} mass {scalar} inertia {scalars} [in {frame}]", "Body",
     "a body at its mass center: xx, yy, zz and, if not zero, xy, yz, zx"},
    {"gravity", "{vector}", "Load", "the gravitational acceleration of all bodies"},
    {"force", "{vector} at {point}", "Load", "a force on a point"},
    {"force_between", "{vector} at {point} and {point}", "Load",
     "a force and its reaction on the second point"},
    {"torque", "{vector} on {frame}", "Load", "a torque on a body"},
    {"torque_between", "{vector} on {frame} and {frame}", "Load",
     "a torque and its reaction on the second frame"},
    {"spring", "{point} to {point} stiffness {scalar} [length {scalar}]", "Load", "a straight spring"},
    {"damper", "{point} to {point} damping {scalar}", "Load", "a straight damper"},
    {"torsional_spring", "{scalar} stiffness {scalar} [rest {scalar}]", "Load", "a spring at an angle"},
    {"torsional_damper", "{frame} to {frame} damping {scalar}", "Load", "a damper between two frames"},
    {"potential_energy", "{scalar}", "Load", "a potential energy of the coordinates"},
};

inline const word* find_word(std::string_view called) {
  for (const word& each : words)
    if (each.called == called) return &each;
  return nullptr;
}

} // namespace playground
