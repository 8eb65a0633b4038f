// builds: clang++ all
// Muscles with rigid and elastic tendons: compiled and interpreted code, batches and constant expressions.
#include "runtime/agreement.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/blocks.hpp>
#include <kanexpr/compiled/constant_values.hpp>
#include <kanexpr/kanexpr.hpp>

namespace {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"m"> m;
constexpr parameter<"F"> F;
constexpr input<"e"> e;
struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct Fixed : offset<Fixed, O, 0.3 * N::y> {};
struct P : offset<P, O, 0.05 * A::x> {};
struct Bob : particle<Bob, P, m> {};
struct Fast
    : muscle<Fast, straight<Fixed, P>, e - 0.1 * u,
             muscle_parameters{
                 .peak_isometric_force = F, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2}> {};
struct Slow : muscle<Slow, given_length<0.3 + 0.02 * q>, e,
                     muscle_parameters{.peak_isometric_force = F,
                                       .optimal_fiber_length = 0.12,
                                       .tendon_slack_length = 0.2,
                                       .formulation = muscle_formulation::fiber_length}> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<Fast, Slow>> {};
using eom = equations_of_motion<System>;

TEST(agreement, muscles) { agreement::check_rhs<System>(); }

constexpr auto pulled = constant_state<System>(
    {{q, 0.1}, {u, -0.2}, {Fast::activation, 0.4}, {Slow::activation, 0.6}, {Slow::fiber_length, 0.85}});
constexpr auto values = constant_parameters<System>({{m, 0.5}, {F, 400}});
constexpr auto driven = constant_inputs<System>({{e, 0.3}});
constexpr auto rates = eom::rhs.constant(pulled, values, driven);
static_assert(rates(0) == -0.2 && rates(2) < 0 && rates(3) < 0);

TEST(agreement, muscles_in_constant_expressions) {
  const eom::state x{
      {q, 0.1}, {u, -0.2}, {Fast::activation, 0.4}, {Slow::activation, 0.6}, {Slow::fiber_length, 0.85}};
  const eom::parameters p{{m, 0.5}, {F, 400}};
  const eom::state called = eom::rhs(x, p, eom::inputs{{e, 0.3}});
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(rates(i), called(i), 1e-14 * std::abs(called(i))) << i;
  using two = batch<2>;
  two::state<System> both;
  eom::state other = x;
  other[Slow::fiber_length] = 1.1;
  two::set(both, 0, x), two::set(both, 1, other);
  const auto found = eom::rhs(both, p, eom::inputs{{e, 0.3}});
  EXPECT_LT((two::get(found, 0) - called).norm(), 1e-13 * called.norm());
  EXPECT_LT(two::get(found, 1)(4), called(4)); // the tendon is shorter, and pulls less
}

} // namespace
