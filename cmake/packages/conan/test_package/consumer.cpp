// A pendulum: its rates at one state.
#include <kanexpr/kanexpr.hpp>

#include <cmath>

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;

struct N : inertial_frame<N> {}; // x points down
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, 2.0 * A::x> {};
struct Bob : particle<Bob, P, 1.0> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<gravity<9.81 * N::x>>> {};

int main() {
  using eom = equations_of_motion<System>;
  const Eigen::Vector2d rate = eom::rhs(eom::state{{q, 0.5}, {u, 0}});
  return std::abs(rate(1) + 9.81 / 2 * std::sin(0.5)) < 1e-15 ? 0 : 1;
}
