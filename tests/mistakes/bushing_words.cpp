// Bushings with arguments that they do not take.
#include "joints.hpp"

// expect: the bushing between Arm and Ground lacks an argument; write bushing<Body, Base, six stiffnesses,
// expect: six dampings>
namespace n1 {
struct System : jointed<joints<Arm>, loads<bushing<Arm, Ground, 1, 1, 1>>> {};
void f() { use<System>(); }
} // namespace n1

// expect: the bushing between Arm and Ground lacks an argument; write bushing<Body, Base, six stiffnesses,
// expect: six dampings>
namespace n2 {
struct System : jointed<joints<Arm>, loads<bushing<Arm, Ground, 1, 1, 1, 2, 2, 2, 3, 3, 3>>> {};
void f() { use<System>(); }
} // namespace n2

// expect: a bushing acts between frame Arm and itself
namespace n3 {
struct System : jointed<joints<Arm>, loads<bushing<Arm, Arm, 1, 1, 1, 2, 2, 2>>> {};
void f() { use<System>(); }
} // namespace n3

// expect: a stiffness of the bushing between Arm and Ground contains the coordinate q_Arm; it may contain
// expect: only parameters, inputs and time
namespace n4 {
struct System : jointed<joints<Arm>, loads<bushing<Arm, Ground, 1, 1, 1, 2, 2, q_of<Arm>>>> {};
void f() { use<System>(); }
} // namespace n4
