// expect: the quantity given for m does not convert to its unit, kg
#include <kanexpr/boost_units.hpp>
#include <kanexpr/kanexpr.hpp>

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"m", units::si::kilogram> m;
constexpr parameter<"k"> k;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, q * N::x> {};
struct Mass : particle<Mass, P, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Mass>,
                            loads<force<P, -k * q * N::x>>> {};

int main() {
  using eom = equations_of_motion<System>;
  const eom::parameters p{{m, 2. * boost::units::si::meters}, {k, 5}};
  return eom::udot(eom::state{0.1, 0}, p)(0) < 0;
}
