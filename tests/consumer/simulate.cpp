#include <kanexpr/simulate.hpp>

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;

struct N : inertial_frame<N> {}; // x points down
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, A::x> {};
struct Bob : particle<Bob, P, 1> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<gravity<9.81 * N::x>>> {};

int main() {
  const auto run = simulate<System>({{q, 0.1}, {u, 0}}, {}, {0, 1});
  return run && run.time == 1 ? 0 : 1;
}
