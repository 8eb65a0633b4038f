// Motions and derivatives that are requested in unsupported forms.
#include "shapes.hpp"
#include <kanexpr/ensembles/run_output.hpp>
#include <kanexpr/simulations/events/event.hpp>

// expect: an expression with P uses position_of with something other than two points; write
// expect: position_of<point, from>
namespace n1 {
struct System : loaded<weight> {};
auto f() { return kanexpr::function<System, position_of<P>>{}(state<System>(), parameter_values<System>()); }
} // namespace n1

// expect: an expression with O uses position_of with something other than two points; write
// expect: position_of<point, from>
namespace n2 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, position_of<O, P, N>>{}(state<System>(), parameter_values<System>());
}
} // namespace n2

// expect: an expression with P names an extra frame or point; motions are relative to the inertial frame:
// expect: velocity_of<point>
namespace n3 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, velocity_of<P, N>>{}(state<System>(), parameter_values<System>());
}
} // namespace n3

// expect: an expression with A names an extra frame or point; motions are relative to the inertial frame:
// expect: velocity_of<point>
namespace n4 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, angular_velocity_of<A, N>>{}(state<System>(), parameter_values<System>());
}
} // namespace n4

// expect: A, which an expression uses as a point, is a frame
namespace n5 {
struct System : loaded<weight> {};
auto f() { return kanexpr::function<System, velocity_of<A>>{}(state<System>(), parameter_values<System>()); }
} // namespace n5

// expect: P, which an expression uses as a frame, is a point
namespace n6 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, angular_velocity_of<P>>{}(state<System>(), parameter_values<System>());
}
} // namespace n6

// expect: an expression with P takes the derivative of a vector without a frame; write
// expect: derivative_in<frame>(vector)
namespace n7 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, derivative(velocity_of<P>)>{}(state<System>(), parameter_values<System>());
}
} // namespace n7

// expect: an expression with O takes the derivative of a vector without a frame; write
// expect: derivative_in<frame>(vector)
namespace n8 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, derivative_in(position_of<O, P>)>{}(state<System>(),
                                                                       parameter_values<System>());
}
} // namespace n8

// expect: an expression with q takes the derivative of a scalar in a frame; write derivative(scalar)
namespace n9 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, derivative_in<N>(q * q)>{}(state<System>(), parameter_values<System>());
}
} // namespace n9

// expect: an expression with q uses in_axes_of with something other than a vector and a frame; write
// expect: in_axes_of<frame>(vector)
namespace n10 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, in_axes_of<N>(q)>{}(state<System>(), parameter_values<System>());
}
} // namespace n10

// expect: an expression with P uses in_axes_of with something other than a vector and a frame; write
// expect: in_axes_of<frame>(vector)
namespace n11 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, in_axes_of(velocity_of<P>)>{}(state<System>(), parameter_values<System>());
}
} // namespace n11

// expect: an expression with u takes a partial derivative with respect to something that is not a symbol
namespace n12 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, partial(velocity_of<P>, 2 * u)>{}(state<System>(),
                                                                     parameter_values<System>());
}
} // namespace n12

// expect: an expression with P takes a partial derivative with respect to something that is not a symbol
namespace n13 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, partial(velocity_of<P>, N::x)>{}(state<System>(),
                                                                    parameter_values<System>());
}
} // namespace n13

// expect: an expression with O takes a partial derivative with respect to something that is not a symbol
namespace n14 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, jacobian(velocity_of<O>, 2 * u)>{}(state<System>(),
                                                                      parameter_values<System>());
}
} // namespace n14

// expect: a function requests something that is not an expression of a model
namespace n15 {
struct System : loaded<weight> {};
auto f() { return kanexpr::function<System, nullptr>{}(state<System>(), parameter_values<System>()); }
} // namespace n15

// expect: an expression with u uses =; write equations with ==
namespace n16 {
struct System : loaded<weight> {};
auto f() { return kanexpr::function<System, (u = 2)>{}(state<System>(), parameter_values<System>()); }
} // namespace n16

// expect: an expression with u uses ^; write pow(x, n) for a power
namespace n17 {
struct System : loaded<weight> {};
auto f() {
  return kanexpr::function<System, magnitude(velocity_of<P>) * (u ^ 2)>{}(state<System>(),
                                                                          parameter_values<System>());
}
} // namespace n17

// expect: the force at P names an extra frame or point; motions are relative to the inertial frame:
// expect: velocity_of<point>
namespace n18 {
struct System : loaded<force<P, -c * velocity_of<P, N>>> {};
void f() { use<System>(); }
} // namespace n18

// expect: the argument of when<...>, with P, is a vector; it must be a scalar that can cross zero
namespace n19 {
struct System : loaded<weight> {};
auto f() { return when<System, velocity_of<P>>("still"); }
} // namespace n19

// expect: the argument of when<...> is not an expression; it must be a scalar that can cross zero
namespace n20 {
struct System : loaded<weight> {};
auto f() { return when<System, nullptr>("never"); }
} // namespace n20

// expect: the output of a study, with P, is a vector; it must be a scalar
namespace n21 {
struct System : loaded<weight> {};
run_output<System> f() { return at_end<velocity_of<P>>("v"); }
} // namespace n21
