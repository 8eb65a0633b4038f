// A planar chain of 32 rods, each angle measured from the rod before.
#include <models/pendulum6.hpp>

#include <utility>

template <class Rods>
struct chain;
template <int... i>
struct chain<std::integer_sequence<int, i...>>
    : kanexpr::kane_system<kanexpr::inertial<pendulum6::N>, kanexpr::coordinates<pendulum6::q<i + 1>...>,
                           kanexpr::speeds<pendulum6::u<i + 1>...>,
                           kanexpr::kinematics<(dot(pendulum6::q<i + 1>) == pendulum6::u<i + 1>)...>,
                           kanexpr::bodies<pendulum6::Body<i + 1>...>,
                           kanexpr::loads<kanexpr::gravity<-9.81 * pendulum6::N::y>>> {};
struct System : chain<std::make_integer_sequence<int, 32>> {};

using eom = kanexpr::equations_of_motion<System>;

auto accelerations(const eom::state& x) { return eom::udot(x); }
