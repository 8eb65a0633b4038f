// builds: clang++
// An extended system equals one that is written as a whole.
#include <kanexpr/kanexpr.hpp>
#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr;

namespace arm {

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr input<"T"> T;
constexpr input<"F"> F;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, l * A::x> {};
struct S : offset<S, O, s * N::x> {};
struct Bob : particle<Bob, P, m> {};
struct Block : particle<Block, S, 2 * m> {};

struct Pendulum
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<l, m>,
                  inputs<T>, bodies<Bob>, loads<gravity<-9.81 * N::y>, torque<A, T * N::z>>> {};

/// Additional loads and inputs, and a second degree of freedom.
struct Pushed : extended<Pendulum, inputs<F>, loads<force<P, F * N::x>>> {};
struct WithBlock : extended<Pendulum, coordinates<s>, speeds<v>, kinematics<dot(s) == v>, bodies<Block>,
                            loads<spring<S, P, 3, 1>>, loads<damper<S, P, 0.5>>> {};
struct Whole
    : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>, kinematics<dot(q) == u, dot(s) == v>,
                  parameters<l, m>, inputs<T>, bodies<Bob, Block>,
                  loads<gravity<-9.81 * N::y>, torque<A, T * N::z>, spring<S, P, 3, 1>, damper<S, P, 0.5>>> {
};
struct Twice : extended<Pushed, loads<damper<O, S, 1>>, bodies<Block>, coordinates<s>, speeds<v>,
                        kinematics<dot(s) == v>> {};

} // namespace arm

TEST(extended, has_more_loads_and_inputs) {
  using namespace arm;
  using eom = equations_of_motion<Pushed>;
  const eom::state x{{q, 0.4}, {u, -0.3}};
  const eom::parameters p{{l, 0.7}, {m, 2}};
  const eom::inputs r{{T, 0.2}, {F, 5}};
  const double expected = (0.2 - 5 * 0.7 * std::sin(0.4) - 2 * 9.81 * 0.7 * std::cos(0.4)) / (2 * 0.7 * 0.7);
  EXPECT_NEAR(eom::udot(x, p, r)[0], expected, 1e-13 * std::abs(expected));
}

TEST(extended, is_the_system_that_is_written_whole) {
  using namespace arm;
  using some = equations_of_motion<WithBlock>;
  using whole = equations_of_motion<Whole>;
  const some::state x{{q, 0.4}, {u, -0.3}, {s, 0.9}, {v, 1.1}};
  const some::parameters p{{l, 0.7}, {m, 1.3}};
  const auto found = some::udot(x, p, some::inputs(0.2));
  const auto expected = whole::udot(whole::state(x), whole::parameters(p), whole::inputs(0.2));
  EXPECT_TRUE(found == expected);
  static_assert(some::cost(some::udot).multiplications == whole::cost(whole::udot).multiplications);
}

TEST(extended, can_be_extended_again) {
  using namespace arm;
  using eom = equations_of_motion<Twice>;
  const eom::state x{{q, 0.4}, {u, -0.3}, {s, 0.9}, {v, 1.1}};
  EXPECT_NEAR(eom::udot(x, eom::parameters{{l, 0.7}, {m, 2}}, eom::inputs{{T, 0.2}, {F, 5}})[1], -1.1 / 4,
              1e-14);
}

/// A system that mentions its inputs but does not list them: F, and inputs that nothing mentions, follow T.
namespace arm {

constexpr input<"G"> G;
constexpr input<"H"> H;
struct Unlisted
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<l, m>,
                  bodies<Bob>, loads<gravity<-9.81 * N::y>, torque<A, T * N::z>>> {};
struct UnlistedPushed : extended<Unlisted, loads<force<P, F * N::x>, force<P, G * N::y>>, inputs<G, H>,
                                 inputs<F>, used_elsewhere<H>> {};
struct PushedAgain : extended<UnlistedPushed, inputs<input<"K">{}>, used_elsewhere<input<"K">{}>> {};

} // namespace arm

TEST(extended, adds_inputs_to_those_that_a_system_mentions) {
  using namespace arm;
  using eom = equations_of_motion<UnlistedPushed>;
  static_assert(eom::inputs::RowsAtCompileTime == 4);
  const eom::state x{{q, 0.4}, {u, -0.3}};
  const eom::parameters p{{l, 0.7}, {m, 2}};
  const eom::inputs r(0.2, 3, 0, 5); // T, G, H, F
  EXPECT_EQ(r[T], 0.2);
  EXPECT_EQ(r[G], 3);
  EXPECT_EQ(r[F], 5);
  const double expected =
      (0.2 - 5 * 0.7 * std::sin(0.4) + (3 - 2 * 9.81) * 0.7 * std::cos(0.4)) / (2 * 0.7 * 0.7);
  EXPECT_NEAR(eom::udot(x, p, r)[0], expected, 1e-13 * std::abs(expected));
  static_assert(equations_of_motion<PushedAgain>::inputs::RowsAtCompileTime == 5);
}

/// Symbols that occur only in an expression follow all those that a system without lists mentions.
namespace arm {

constexpr parameter<"k"> k;
struct Read : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                          loads<gravity<-9.81 * N::y>, torque<A, T * N::z>>, used_elsewhere<k, H>> {};
struct ReadByLists : extended<Pendulum, inputs<H>, parameters<k>, used_elsewhere<k, H>> {};

} // namespace arm

template <class System>
double scale_of(const parameter_values<System>& p, const input_values<System>& r) {
  return function<System, arm::k * arm::q + arm::H>{}(state<System>{{arm::q, 0.4}, {arm::u, 0}}, p, r);
}

TEST(extended, has_symbols_that_are_used_elsewhere) {
  using namespace arm;
  EXPECT_NEAR(scale_of<Read>({{l, 1}, {m, 1}, {k, 5}}, {{T, 0}, {H, 3}}), 5, 1e-15);
  EXPECT_NEAR(scale_of<ReadByLists>({{l, 1}, {m, 1}, {k, 5}}, {{T, 0}, {H, 3}}), 5, 1e-15);
  static_assert(Read::record.parameters.size == 0);
  static_assert(equations_of_motion<Read>::parameters::RowsAtCompileTime == 3);
}

/// By Lagrange's method, with constraints.
constexpr auto brake = constant<2, units::si::newton * units::si::meter * units::si::second>;
struct Braked : extended<four_bar::LagrangeSystem,
                         loads<torque<four_bar::C, -brake * dot(four_bar::q1) * four_bar::N::z>>> {};

TEST(extended, keeps_the_method_and_the_constraints) {
  using eom = equations_of_motion<Braked>;
  using before = equations_of_motion<four_bar::LagrangeSystem>;
  static_assert(eom::coordinates == 3 && eom::state::RowsAtCompileTime == 6);
  eom::state x;
  x << 0.5, 0.3, -1.2, 1, 0.4, -0.2;
  const eom::parameters p = eom::parameters::Constant(1.1);
  const eom::inputs r(0.7);
  const Eigen::VectorXd change =
      eom::active_forces(x, p, r) -
      before::active_forces(before::state(x), before::parameters(p), before::inputs(r));
  const auto A = before::dependency(before::state(x), before::parameters(p));
  const Eigen::Vector3d torque(-2, -2, -2); // C rotates with all three rates
  const double expected = torque(0) + A(0, 0) * torque(1) + A(1, 0) * torque(2);
  ASSERT_EQ(change.size(), 1);
  EXPECT_NEAR(change(0), expected, 1e-13 * std::abs(expected));
}

} // namespace
