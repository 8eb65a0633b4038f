// expect: explicit_form_at needs the rate of speed u: call it as explicit_form_at(x, p, r, a)
#include "pendulum.hpp"

struct P2 : offset<P2, P, q * N::x> {};
struct Slider : particle<Slider, P2, m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            bodies<Bob, Slider>, loads<weight>> {};
using lin = linearization<System>;

int main() {
  const auto [A, B] = lin::explicit_form_at(lin::state(), lin::parameters(), lin::inputs());
  return A(0, 0) > B.size();
}
