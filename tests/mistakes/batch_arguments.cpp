#include <kanexpr/batch.hpp>
#include <kanexpr/fixed_step.hpp>

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"m"> m;
constexpr input<"F"> F;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, q * N::x> {};
struct Mass : particle<Mass, P, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Mass>,
                            inputs<F>, loads<force<P, F * N::x>>> {};
using eom = equations_of_motion<System>;

many_results<decltype(eom::udot)> results(4);
rollout<runge_kutta_4<System>> ahead(4, {});
many<eom::state> x(4);
const many<eom::state> read_only(4);
many<state<System, float>> of_less_precision(4);
const many<parameter_values<System, float>> p_of_less_precision(4);
const eom::state one = eom::state::Zero();
const eom::parameters p(1);
const eom::inputs r(0);

// expect: the precision of the `many` arguments differs from that of the results
const status of_float = results.evaluate(of_less_precision, p, r);

// expect: evaluate takes `many` states; for one state, call the function itself
const status of_one = results.evaluate(one, p, r);

// expect: the precision of the `many` arguments differs from that of the states
const status by_float = ahead.run(x, p_of_less_precision, r);

// expect: run requires non-const `many` states of its system and precision
const status of_constant = ahead.run(read_only, p, r);

// expect: run takes `many` states; for one state, call the step itself
const status moved_one = ahead.run(one, p, r);

// expect: the inputs must be those of one system, `many`, or a const function (t, x), such as a lambda
// expect: without `mutable`
const status by_mutable =
    ahead.run(x, p, [calls = 0](double, const eom::state&) mutable { return eom::inputs(++calls); });
