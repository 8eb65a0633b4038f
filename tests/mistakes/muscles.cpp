// Muscles with the wrong arguments or parameters, or in the wrong place.
#include "state_variables.hpp"

#include <kanexpr/blocks.hpp>

template <class... Loads>
using pulled = moved<loads<Loads...>>;
using Line = straight<O, P>;

// expect: the muscle M lacks an argument; write muscle<Self, Path, excitation, muscle_parameters{...}>
namespace m1 {
struct M : muscle<M, Line, F> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m1

// expect: the muscle M takes muscle_parameters{...} after its excitation
namespace m2 {
struct M : muscle<M, Line, F, 500> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m2

// expect: the muscle M has no tendon slack length; set it in muscle_parameters{...}
namespace m3 {
struct M : muscle<M, Line, F, muscle_parameters{.peak_isometric_force = 500.0, .optimal_fiber_length = 0.1}> {
};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m3

// expect: the optimal fiber length of the muscle M contains the coordinate q; it may contain only
// expect: parameters, inputs and time
namespace m4 {
struct M : muscle<M, Line, F,
                  muscle_parameters{.peak_isometric_force = 500.0,
                                    .optimal_fiber_length = 0.1 * q,
                                    .tendon_slack_length = 0.2}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m4

// expect: the peak isometric force of the muscle M is not positive
namespace m5 {
struct M
    : muscle<M, Line, F,
             muscle_parameters{
                 .peak_isometric_force = -500.0, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m5

// expect: the muscle acts along P, which is a point, not a pathway; write straight<P, Q>, for example
namespace m6 {
struct M
    : muscle<M, P, F,
             muscle_parameters{
                 .peak_isometric_force = 500.0, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m6

// expect: a_M is listed twice among the state variables
namespace m7 {
struct M
    : muscle<M, Line, F,
             muscle_parameters{
                 .peak_isometric_force = 500.0, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2}> {};
struct System : pulled<M, M> {};
void f() { use<System>(); }
} // namespace m7

// expect: state variable F_M, which the force at P contains, is not in states<...> or in a listed block
namespace m8 {
struct M
    : muscle<M, Line, F,
             muscle_parameters{
                 .peak_isometric_force = 500.0, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2}> {};
struct System : pulled<M, force<P, M::tendon_force * N::x>> {};
void f() { use<System>(); }
} // namespace m8

// expect: the pennation of the muscle M contains the rate of speed u; it may contain only parameters,
// expect: inputs and time
namespace m9 {
struct M : muscle<M, Line, F,
                  muscle_parameters{.peak_isometric_force = 500.0,
                                    .optimal_fiber_length = 0.1,
                                    .tendon_slack_length = 0.2,
                                    .pennation = dot(u)}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m9

// expect: blocks<...> lists M, which is a load; list it in loads<...>
namespace m10 {
struct M
    : muscle<M, Line, F,
             muscle_parameters{
                 .peak_isometric_force = 500.0, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2}> {};
struct System : moved<blocks<M>> {};
void f() { use<System>(); }
} // namespace m10

// expect: the activation of the muscle M is a vector; it must be a scalar
namespace m11 {
struct M : muscle<M, Line, N::x,
                  muscle_parameters{.peak_isometric_force = 500.0,
                                    .optimal_fiber_length = 0.1,
                                    .tendon_slack_length = 0.2,
                                    .has_activation_dynamics = false}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m11

// expect: the tendon slack length of the muscle M is w [N], but must be in m
namespace m12 {
constexpr parameter<"w", units::si::newton> w;
struct M : muscle<M, Line, F,
                  muscle_parameters{
                      .peak_isometric_force = 500.0, .optimal_fiber_length = 0.1, .tendon_slack_length = w}> {
};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m12

// expect: the length of the muscle M is theta [rad], but must be in m
namespace m13 {
constexpr coordinate<"theta", units::si::radian> theta;
struct A : rotated<A, N, theta, N::z> {};
struct C : offset<C, O, 0.1 * A::x> {};
struct M
    : muscle<M, given_length<theta>, F,
             muscle_parameters{
                 .peak_isometric_force = 500.0, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2}> {};
struct Bob : particle<Bob, C, m> {};
struct System : kane_system<inertial<N>, coordinates<theta>, speeds<u>, kinematics<dot(theta) == u>,
                            bodies<Bob>, loads<M>> {};
void f() { use<System>(); }
} // namespace m13

// expect: the muscle M has no peak isometric force; set it in muscle_parameters{...}
namespace m14 {
struct M : muscle<M, Line, F, muscle_parameters{.optimal_fiber_length = 0.1, .tendon_slack_length = 0.2}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m14

// expect: the tendon strain of the muscle M is not positive
namespace m15 {
struct M : muscle<M, Line, F,
                  muscle_parameters{.peak_isometric_force = 500.0,
                                    .optimal_fiber_length = 0.1,
                                    .tendon_slack_length = 0.2,
                                    .tendon_strain = -0.05}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m15

// expect: the fiber damping of the muscle M is negative
namespace m16 {
struct M : muscle<M, Line, F,
                  muscle_parameters{.peak_isometric_force = 500.0,
                                    .optimal_fiber_length = 0.1,
                                    .tendon_slack_length = 0.2,
                                    .fiber_damping = -0.1}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m16

// expect: the passive strain of the muscle M contains the speed u; it may contain only parameters, inputs and
// expect: time
namespace m17 {
struct M : muscle<M, Line, F,
                  muscle_parameters{.peak_isometric_force = 500.0,
                                    .optimal_fiber_length = 0.1,
                                    .tendon_slack_length = 0.2,
                                    .passive_strain = u}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m17

// expect: the activation of the muscle M contains the rate of speed u
namespace m18 {
struct M : muscle<M, Line, dot(u),
                  muscle_parameters{.peak_isometric_force = 500.0,
                                    .optimal_fiber_length = 0.1,
                                    .tendon_slack_length = 0.2,
                                    .has_activation_dynamics = false}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m18

// expect: a muscle M acts between point P and itself
namespace m19 {
struct M
    : muscle<M, straight<P, P>, F,
             muscle_parameters{
                 .peak_isometric_force = 500.0, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2}> {};
struct System : pulled<M> {};
void f() { use<System>(); }
} // namespace m19
