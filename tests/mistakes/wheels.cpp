// Wheels and grounds that are incomplete or meaningless.
#include "joints.hpp"

#include <kanexpr/tyres.hpp>

using round_wheel = thin_wheel<Arm, Arm::y, 0.3>;
using flat = flat_ground<Ground, Ground::z>;
template <class Wheel, class Ground_>
using rolls = tyre<Wheel, Ground_, linear_tyre<1000, 1000>, standstill<0.1>>;
struct Far : origin<Far, Ground> {};
struct Hub : offset<Hub, Arm, 0.1 * Arm::x> {};

// expect: begins with neither thin_wheel<...>, toroidal_wheel<...> nor conical_wheel<...>
namespace n1 {
struct System : jointed<joints<Arm>, loads<rolls<flat, round_wheel>>> {};
void f() { use<System>(); }
} // namespace n1

// expect: names no ground; after the wheel, write flat_ground<...>, uneven_ground<...> or straight_rail<...>
namespace n2 {
struct System : jointed<joints<Arm>, loads<rolls<round_wheel, standstill<1>>>> {};
void f() { use<System>(); }
} // namespace n2

// expect: has a conical_wheel<...> on other ground than straight_rail<...>
namespace n3 {
struct System : jointed<joints<Arm>, loads<rolls<conical_wheel<Arm, Arm::y, 0.4, 0.1>, flat>>> {};
void f() { use<System>(); }
} // namespace n3

// expect: has a wheel on a straight_rail<...> that is no conical_wheel<...>
namespace n4 {
using rail = straight_rail<Ground, Ground::x, Ground::z>;
struct System : jointed<joints<Arm>, loads<rolls<round_wheel, rail>>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the tyre between Hub and Ground has a wheel with two frames
namespace n5 {
using wheel = thin_wheel<Hub, Arm::y, 0.3, Arm, Ground>;
struct System : jointed<joints<Arm>, loads<rolls<wheel, flat>>> {};
void f() { use<System>(); }
} // namespace n5

// expect: has an uneven_ground<...> with a number of steps outside of 0 to 9
namespace n6 {
using ground = uneven_ground<Ground, Ground, 0.1 * surface::x, 12>;
struct System : jointed<joints<Arm>, loads<rolls<round_wheel, ground>>> {};
void f() { use<System>(); }
} // namespace n6

// expect: has a straight_rail<...> with more than one radius
namespace n7 {
using rail = straight_rail<Ground, Ground::x, Ground::z, 0.3, 0.4>;
struct System : jointed<joints<Arm>, loads<rolls<conical_wheel<Arm, Arm::y, 0.4, 0.1>, rail>>> {};
void f() { use<System>(); }
} // namespace n7

// expect: the axis of the tyre between Arm and Ground is given in the axes of two frames
namespace n8 {
using wheel = thin_wheel<Arm, Arm::y + Ground::x, 0.3>;
struct System : jointed<joints<Arm>, loads<rolls<wheel, flat>>> {};
void f() { use<System>(); }
} // namespace n8

// expect: the height of the ground of the tyre between Arm and Ground contains surface::z; it is a function
// expect: of surface::x and surface::y
namespace n9 {
using ground = uneven_ground<Ground, Ground, 0.1 * surface::x + surface::z>;
struct System : jointed<joints<Arm>, loads<rolls<round_wheel, ground>>> {};
void f() { use<System>(); }
} // namespace n9

// expect: the rail of the tyre between Arm and Ground has directions in the axes of two frames
namespace n10 {
using rail = straight_rail<Ground, Arm::x, Ground::z>;
struct System : jointed<joints<Arm>, loads<rolls<conical_wheel<Arm, Arm::y, 0.4, 0.1>, rail>>> {};
void f() { use<System>(); }
} // namespace n10

// expect: the radius of the tyre between Arm and Ground contains the coordinate q_Arm; it may contain only
// expect: parameters, inputs and time
namespace n11 {
using wheel = thin_wheel<Arm, Arm::y, q_of<Arm>>;
struct System : jointed<joints<Arm>, loads<rolls<wheel, flat>>> {};
void f() { use<System>(); }
} // namespace n11

// expect: the radius of the tyre between Arm and Ground is not positive
namespace n12 {
using wheel = thin_wheel<Arm, Arm::y, -0.3>;
struct System : jointed<joints<Arm>, loads<rolls<wheel, flat>>> {};
void f() { use<System>(); }
} // namespace n12

// expect: the tyre between Hub and Arm is between a body and itself
namespace n13 {
using wheel = thin_wheel<Hub, Arm::y, 0.3, Arm>;
struct System : jointed<joints<Arm>, loads<rolls<wheel, flat_ground<Arm, Arm::z>>>> {};
void f() { use<System>(); }
} // namespace n13

// expect: the tyre between Arm and Far has points measured from two origins, Ground and Far, whose
// expect: distance is not known
namespace n14 {
struct System : jointed<joints<Arm>, loads<rolls<round_wheel, flat_ground<Far, Ground::z>>>> {};
void f() { use<System>(); }
} // namespace n14

// expect: the axis of the tyre between Arm and Ground is not fixed in Arm; its components may contain only
// expect: numbers and parameters
namespace n15 {
using wheel = thin_wheel<Arm, Arm::y + q_of<Arm> * Arm::x, 0.3>;
struct System : jointed<joints<Arm>, loads<rolls<wheel, flat>>> {};
void f() { use<System>(); }
} // namespace n15

// expect: contact_point<Self, Wheel, Ground> requires a thin_wheel<...>, toroidal_wheel<...> or
// expect: conical_wheel<...>
namespace n16 {
struct Contact : contact_point<Contact, int, flat> {};
} // namespace n16

// expect: Contact has a conical_wheel<...> on other ground than straight_rail<...>
namespace n17 {
struct Contact : contact_point<Contact, conical_wheel<Arm, Arm::y, 0.4, 0.1>, flat> {};
struct System : jointed<joints<Arm>, loads<force<Contact, Ground::x>>> {};
void f() { use<System>(); }
} // namespace n17

// expect: the wheel between Arm and Far has points measured from two origins, Ground and Far, whose
// expect: distance is not known
namespace n18 {
using hilly = uneven_ground<Far, Ground, 0.1 * sin(surface::x)>;
struct Contact : contact_point<Contact, round_wheel, hilly> {};
struct System : jointed<joints<Arm>, loads<force<Contact, Ground::x>>> {};
void f() { use<System>(); }
} // namespace n18
