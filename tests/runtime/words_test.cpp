// builds: clang++
// A mistake in a system is reported by the same sentence at compile time and at run time.
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr input<"T"> T;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct A : rotated<A, N, q, N::z> {};
struct P : offset<P, O, l * A::x> {};
struct Bob : particle<Bob, P, m> {};

using weight = gravity<-9.81 * N::y>;
template <class... Words>
using pendulum =
    kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>, Words...>;
template <class... Words>
using rates_of_pendulum = lagrange_system<inertial<N>, coordinates<q>, Words...>;

template <class System>
std::string mistake() {
  constexpr base::sentence compiled = derivation::stages_of<System>::constrained.mistake;
  model derived = derive<System>();
  EXPECT_EQ(derived.mistake(), compiled.view());
  if (compiled) {
    EXPECT_TRUE(derived.mass_matrix().entries.empty());
    EXPECT_EQ(derived.mistake(), compiled.view());
    EXPECT_EQ((derive<System, velocity_of<P>>().mistake()), compiled.view());
  }
  return derived.mistake();
}

struct Sound : pendulum<loads<weight>> {};
struct LoadAmongWords : pendulum<weight> {};
struct LoadsBeside : pendulum<>, loads<weight> {};
struct LoadsTwice : pendulum<loads<weight>, loads<torque<A, T * N::z>>> {};
struct BodyAmongWords : pendulum<Bob> {};
struct NoBodies : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>> {};
struct NoWord : pendulum<int> {};
struct NoSystem {
  int n;
};
struct TwoSystems : pendulum<>, rates_of_pendulum<bodies<Bob>> {};

TEST(words, are_looked_through_while_a_program_runs) {
  EXPECT_EQ(mistake<Sound>(), "");
  EXPECT_EQ(mistake<LoadAmongWords>(), "gravity is among the words of LoadAmongWords; list it in loads<...>");
  EXPECT_EQ(mistake<LoadsBeside>(), "loads<...> is a separate base class of LoadsBeside; list it with the "
                                    "other words of the system, inside its < >");
  EXPECT_EQ(mistake<LoadsTwice>(), "the system LoadsTwice lists loads<...> twice; write one list");
  EXPECT_EQ(mistake<BodyAmongWords>(), "body Bob is among the words of BodyAmongWords; write bodies<Bob>");
  EXPECT_EQ(mistake<NoBodies>(), "the system NoBodies has no bodies<...>");
  EXPECT_EQ(mistake<NoWord>(), "int is not a word of a system, but NoWord lists it");
  EXPECT_EQ(mistake<NoSystem>(),
            "NoSystem is not a system; derive it from kane_system<...> or lagrange_system<...>");
  EXPECT_EQ(mistake<TwoSystems>(),
            "TwoSystems is derived from two systems; define a separate struct for each");
}

struct LagrangianForKane : pendulum<lagrangian<m * q * q>> {};
struct SpeedsForLagrange : rates_of_pendulum<speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};
struct LagrangianAndBodies : rates_of_pendulum<lagrangian<m * dot(q) * dot(q)>, bodies<Bob>> {};
struct NoEnergy : rates_of_pendulum<> {};
struct BodiesAdded : extended<rates_of_pendulum<lagrangian<m * dot(q) * dot(q)>>, bodies<Bob>> {};

TEST(words, are_those_of_one_method) {
  EXPECT_EQ(mistake<LagrangianForKane>(),
            "the system LagrangianForKane has lagrangian<...>, which only a lagrange_system takes");
  EXPECT_EQ(mistake<SpeedsForLagrange>(), "the system SpeedsForLagrange has speeds<...>; the only speeds of "
                                          "a lagrange_system are the rates of its coordinates");
  EXPECT_EQ(mistake<LagrangianAndBodies>(),
            "the system LagrangianAndBodies has bodies<...> and lagrangian<...>; a Lagrangian contains the "
            "energy of all bodies");
  EXPECT_EQ(mistake<NoEnergy>(), "the system NoEnergy has neither bodies<...> nor lagrangian<...>");
  EXPECT_EQ(mistake<BodiesAdded>(), "the system BodiesAdded has bodies<...> and lagrangian<...>; a "
                                    "Lagrangian contains the energy of all bodies");
}

} // namespace
