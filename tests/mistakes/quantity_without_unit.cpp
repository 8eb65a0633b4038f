// expect: the unit of w is not determined, so its value is a number, not a quantity
#include <kanexpr/boost_units.hpp>
#include <kanexpr/kanexpr.hpp>

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"m", units::si::kilogram> m;
constexpr parameter<"k"> k;
constexpr parameter<"w"> w;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, q * N::x> {};
struct Mass : particle<Mass, P, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Mass>,
                            loads<force<P, -k * exp(w / w) * q * N::x>>> {};

int main() {
  using eom = equations_of_motion<System>;
  const eom::parameters p{{m, 2}, {k, 5.}, {w, 5. * boost::units::si::meters}};
  return eom::udot(eom::state{0.1, 0}, p)(0) < 0;
}
