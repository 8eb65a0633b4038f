// builds: clang++ all
// The same linkage in other words: with equivalent constraints, and with other choices of dependent
// coordinates and speeds.
#include "systems/check_constrained.hpp"

#include <models/four_bar.hpp>

namespace {

using namespace four_bar;

template <class... Constraints>
struct linkage : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u1, u2, u3>,
                             kinematics<dot(q1) == u1, dot(q2) == u2, dot(q3) == u3>, inputs<T>,
                             bodies<Crank, Coupler, Rocker>, loads<gravity<-g * N::y>, torque<A, T * N::z>>,
                             Constraints...> {};

constexpr auto loop = zero_along<position_of<P3, Bearing>, N::x, N::y>;
constexpr auto still = zero_along<velocity_of<P3>, N::x, N::y>;

struct WithoutChoice : linkage<configuration_constraints<loop>> {};
struct ByRocker : linkage<configuration_constraints<loop>, dependent<q1, q2, u1, u2>> {};
struct SaidTwice
    : linkage<configuration_constraints<loop>, velocity_constraints<still>, dependent<q2, q3, u2, u3>> {};
struct ByScalars
    : linkage<
          configuration_constraints<dot(position_of<P3, O>, N::x) == l0, dot(position_of<P3, O>, N::y) == 0>,
          dependent<q2, q3, u2, u3>> {};
struct SpeedsOnly : linkage<velocity_constraints<still>, dependent<u2, u3>> {};

template <class System>
void moves_alike() {
  using eom = kanexpr::equations_of_motion<System>;
  const oracle::system reference = oracle::load("four_bar");
  const auto p = check::parameters_by_name<System>(reference.parameters);
  for (const oracle::state& s : reference.states) {
    const auto x = check::state_by_name<System>(reference.q, s.q, reference.u, s.u);
    const auto udot = check::without_heap(eom::udot, x, p, check::inputs_by_name<System>(reference.r, s.r));
    EXPECT_TRUE(udot.status);
    EXPECT_TRUE(oracle::close(udot, check::pick({"u1", "u2", "u3"}, reference.u, s.udot), 1e-11));
  }
}

TEST(four_bar_in_other_words, without_choice) { moves_alike<WithoutChoice>(); }
TEST(four_bar_in_other_words, by_the_rocker) { moves_alike<ByRocker>(); }
TEST(four_bar_in_other_words, said_twice) { moves_alike<SaidTwice>(); }
TEST(four_bar_in_other_words, by_scalars) { moves_alike<ByScalars>(); }
TEST(four_bar_in_other_words, by_speeds_only) { moves_alike<SpeedsOnly>(); }

} // namespace
