// Tyres that are incomplete or meaningless.
#include "joints.hpp"

#include <kanexpr/tyres.hpp>

using rim = thin_wheel<Arm, Arm::y, 0.3>;
using road = flat_ground<Ground, Ground::z>;
using grip = brush_tyre<0.8, 1000>;
using weight = wheel_load<50>;
using slow = standstill<0.1>;

// expect: the tyre between Arm and Ground needs one law: linear_tyre<...>, brush_tyre<...> or
// expect: magic_formula<...>
namespace n1 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, weight, slow>>> {};
void f() { use<System>(); }
} // namespace n1

// expect: the tyre between Arm and Ground needs one standstill<speed>
namespace n2 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, grip, weight>>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the tyre between Arm and Ground needs a load: wheel_load<Fz> or radial_stiffness<k, c, width>
namespace n3 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, grip, slow>>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the tyre between Arm and Ground has more than one of wheel_load<...> and radial_stiffness<...>
namespace n4 {
using twice = tyre<rim, road, grip, weight, radial_stiffness<100, 1, 0.01>, slow>;
struct System : jointed<joints<Arm>, loads<twice>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the tyre between Arm and Ground has an argument that is not a word of a tyre, such as
// expect: wheel_load<Fz> or standstill<v0>
namespace n5 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, grip, weight, slow, gravity<Ground::z>>>> {};
void f() { use<System>(); }
} // namespace n5

// expect: the tyre between Arm and Ground lacks an argument; write brush_tyre<coefficient of friction, slip
// expect: stiffness, cornering stiffness>
namespace n6 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, brush_tyre<0.8>, weight, slow>>> {};
void f() { use<System>(); }
} // namespace n6

// expect: the tyre between Arm and Ground has a magic formula without the coefficient Fz0
namespace n7 {
inline constexpr tyre_coefficients bare{.R0 = 0.3, .pCy1 = 1.3, .pDy1 = 1, .pKy1 = -15, .pKy2 = 1.5};
struct System : jointed<joints<Arm>, loads<tyre<rim, road, magic_formula<bare>, weight, slow>>> {};
void f() { use<System>(); }
} // namespace n7

// expect: the tyre between Arm and Ground has a magic formula and a pneumatic_trail<...> or
// expect: camber_stiffness<...>, which the formula contains
namespace n8 {
inline constexpr tyre_coefficients slick{
    .Fz0 = 50, .R0 = 0.3, .pCy1 = 1.3, .pDy1 = 1, .pKy1 = -15, .pKy2 = 1.5};
using doubled = tyre<rim, road, magic_formula<slick>, weight, slow, pneumatic_trail<0.02>>;
struct System : jointed<joints<Arm>, loads<doubled>> {};
void f() { use<System>(); }
} // namespace n8

// expect: the speed of standstill of the tyre between Arm and Ground is not positive
namespace n9 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, grip, weight, standstill<-0.1>>>> {};
void f() { use<System>(); }
} // namespace n9

// expect: the load of the tyre between Arm and Ground is a vector; it must be a scalar
namespace n10 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, grip, wheel_load<Ground::z>, slow>>> {};
void f() { use<System>(); }
} // namespace n10

// expect: the tyre between Arm and Ground has two relaxation<...>
namespace n11 {
using lagging = tyre<rim, road, grip, weight, slow, relaxation<0.2, 0.4>, relaxation<0.2, 0.4>>;
struct System : jointed<joints<Arm>, loads<lagging>> {};
void f() { use<System>(); }
} // namespace n11

// expect: a relaxation length of the tyre between Arm and Ground contains the coordinate q_Arm; it may
// expect: contain only parameters, inputs and time
namespace n12 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, grip, weight, slow, relaxation<0.2, Arm::q<0>>>>> {
};
void f() { use<System>(); }
} // namespace n12

// expect: the tyre between Arm and Ground has two pneumatic_trail<...>
namespace n13 {
struct System
    : jointed<joints<Arm>,
              loads<tyre<rim, road, grip, weight, slow, pneumatic_trail<0.02>, pneumatic_trail<0.03>>>> {};
void f() { use<System>(); }
} // namespace n13

// expect: the tyre between Arm and Ground has two camber_stiffness<...>
namespace n14 {
struct System
    : jointed<joints<Arm>,
              loads<tyre<rim, road, grip, weight, slow, camber_stiffness<90>, camber_stiffness<80>>>> {};
void f() { use<System>(); }
} // namespace n14

// expect: the tyre between Arm and Ground has two effective_radius<...>
namespace n15 {
struct System
    : jointed<joints<Arm>,
              loads<tyre<rim, road, grip, weight, slow, effective_radius<0.29>, effective_radius<0.3>>>> {};
void f() { use<System>(); }
} // namespace n15

// expect: the tyre between Arm and Ground lacks an argument; write relaxation<longitudinal length, lateral
// expect: length>
namespace n16 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, grip, weight, slow, relaxation<0.2>>>> {};
void f() { use<System>(); }
} // namespace n16

// expect: the radial stiffness of the tyre between Arm and Ground is not positive
namespace n17 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, grip, radial_stiffness<-100, 0.1, 0.01>, slow>>> {
};
void f() { use<System>(); }
} // namespace n17

// expect: the width of the tyre between Arm and Ground contains the coordinate q_Arm; it may contain only
// expect: parameters, inputs and time
namespace n18 {
struct System
    : jointed<joints<Arm>, loads<tyre<rim, road, grip, radial_stiffness<100, 0.1, q_of<Arm>>, slow>>> {};
void f() { use<System>(); }
} // namespace n18

// expect: a relaxation length of the tyre between Arm and Ground is not positive
namespace n19 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, grip, weight, slow, relaxation<0.2, -0.4>>>> {};
void f() { use<System>(); }
} // namespace n19

// expect: the effective radius of the tyre between Arm and Ground is a vector; it must be a scalar
namespace n20 {
struct System
    : jointed<joints<Arm>, loads<tyre<rim, road, grip, weight, slow, effective_radius<0.3 * Ground::z>>>> {};
void f() { use<System>(); }
} // namespace n20

// expect: the tyre between Arm and Ground lacks an argument; write linear_tyre<slip stiffness, cornering
// expect: stiffness>
namespace n21 {
struct System : jointed<joints<Arm>, loads<tyre<rim, road, linear_tyre<1000>, slow>>> {};
void f() { use<System>(); }
} // namespace n21

// expect: the pneumatic trail of the tyre between Arm and Ground contains the rate of speed u_Arm
namespace n22 {
struct System
    : jointed<joints<Arm>, loads<tyre<rim, road, grip, weight, slow, pneumatic_trail<dot(u_of<Arm>)>>>> {};
void f() { use<System>(); }
} // namespace n22

struct Axle : offset<Axle, Arm, 0.1 * Arm::x> {};

// expect: the tyre between Axle and Ground has a wheel whose center is a point; write its frame after the
// expect: radius, as in thin_wheel<Center, axis, radius, Frame>
namespace n23 {
struct System : jointed<joints<Arm>, loads<tyre<thin_wheel<Axle, Arm::y, 0.3>, road, grip, weight, slow>>> {};
void f() { use<System>(); }
} // namespace n23

// expect: loads<...> lists wheel_load<50>, which is an argument of tyre<...>
namespace n24 {
struct System : jointed<joints<Arm>, loads<weight>> {};
void f() { use<System>(); }
} // namespace n24

// expect: loads<...> lists flat_ground<...>, which is an argument of tyre<...>
namespace n25 {
struct System : jointed<joints<Arm>, loads<road>> {};
void f() { use<System>(); }
} // namespace n25

// expect: loads<...> lists thin_wheel<...>, which is an argument of tyre<...>
namespace n26 {
struct System : jointed<joints<Arm>, loads<rim>> {};
void f() { use<System>(); }
} // namespace n26
