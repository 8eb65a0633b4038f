// Friction with bristles that is incomplete, repeated or meaningless.
#include "joints.hpp"

#include <kanexpr/contact.hpp>

using firm = elastic<100, 1.5>;
using thin = smoothed_over<0.001>;
using rough = lugre_friction<0.4, 0.3, 0.01, 1000, 10, 0.1>;
struct Slider : prismatic<Slider, Ground, axis<Ground::x>, mass> {};

// expect: the friction between Arm and Ground has dahl_friction<...> without a slip speed
namespace b1 {
struct System : jointed<joints<Arm>, loads<friction<Arm, 2, dahl_friction<0.4, 100>>>> {};
void f() { use<System>(); }
} // namespace b1

// expect: the friction between Arm and Ground lacks an argument; write lugre_friction<static, sliding,
// expect: Stribeck speed, stiffness, damping, viscous, slip speed>
namespace b2 {
struct System : jointed<joints<Arm>, loads<friction<Arm, 2, lugre_friction<0.4, 0.3, 0.01>>>> {};
void f() { use<System>(); }
} // namespace b2

// expect: which is along a pathway without points, after which its bristles could be named
namespace b3 {
struct System : jointed<joints<Arm>, loads<friction<given_length<0.1 * q_of<Arm>>, 2, rough>>> {};
void f() { use<System>(); }
} // namespace b3

// expect: which is for a pathway, such as straight<P, Q>, or a joint that turns about one axis or slides
// expect: along one
namespace b4 {
struct Link : spherical<Link, Ground, mass> {};
struct System : jointed<joints<Link>, loads<friction<Link, l, rough>>> {};
void f() { use<System>(); }
} // namespace b4

// expect: z_Arm is listed twice among the state variables
namespace b5 {
struct System : jointed<joints<Arm>, loads<friction<Arm, 2, rough>, friction<Arm, 3, rough>>> {};
void f() { use<System>(); }
} // namespace b5

// expect: state variable z_Slider, which the motor between Arm and Ground contains, is not in
// expect: states<...> or in a listed block
namespace b6 {
struct System : jointed<joints<Arm, Slider>, loads<motor<Arm, T * bristle_of<Slider>>>> {};
void f() { use<System>(); }
} // namespace b6

// expect: has bristles, whose directions do not follow from its normal; turn Ground so that a component of
namespace b7 {
using tilted =
    contact<point_on_plane<Slider, Ground, Ground::x + l * Ground::y + Ground::z>, firm, thin, rough>;
struct System : jointed<joints<Slider>, loads<tilted>> {};
void f() { use<System>(); }
} // namespace b7

// expect: the stiffness of the bristles of the friction with q_Arm is not positive
namespace b8 {
struct System : jointed<joints<Arm>, loads<friction<Arm, 2, dahl_friction<0.4, -1.0, 0.1>>>> {};
void f() { use<System>(); }
} // namespace b8

// expect: the Stribeck speed of the friction with q_Arm contains the coordinate q_Arm
namespace b9 {
struct System
    : jointed<joints<Arm>, loads<friction<Arm, 2, lugre_friction<0.4, 0.3, 0.1 + q_of<Arm>, 100>>>> {};
void f() { use<System>(); }
} // namespace b9

// expect: the stiffness of the bristles of the friction with q_Slider is sigma [N], but must be in N/m
namespace b10 {
constexpr parameter<"sigma", units::si::newton> sigma;
struct System : jointed<joints<Slider>, loads<friction<Slider, 1, dahl_friction<0.4, sigma, 0.1>>>> {};
void f() { use<System>(); }
} // namespace b10
