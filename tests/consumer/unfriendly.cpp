#include <others_headers.hpp>

#include "macros.hpp"

#include <letters.hpp>

#include <every_header.hpp>

#include <no_letters.hpp>

#include "pendulum.hpp"

// Uses a part of everything, so that the warnings cover the contents of templates. It is compiled but never
// run.
int main() {
  using namespace pendulum;
  using eom = kanexpr::equations_of_motion<System>;
  using picture = kanexpr::picture<System, up<-1 * N::x>, show<rod<O, P, 0.02>>, show<sphere<P, 0.07>>,
                                   show_forces<"N">, show_velocities<>, show_frames, plot_energies<"J">,
                                   plot<"speed", magnitude(velocity_of<P>), "m/s">>;

  eom::state x;
  x[q] = 0.5, x[u] = 0;
  eom::parameters p;
  p[l] = 2;
  bool is_good = eom::udot(x, p)(0) < 0 && eom::mass_matrix(x, p)(0) > 0;
  is_good = is_good && kanexpr::function<System, velocity_of<P>>{}(x, p).allFinite();
  const auto [A, B] = kanexpr::linearization<System>::explicit_form(x, p);
  is_good = is_good && A(0, 1) > 0 && B.size() == 0;

  double t = 0;
  kanexpr::runge_kutta_4<System> step;
  is_good = is_good && step(t, x, 1e-3, p) && kanexpr::check_consistency<System>(x, p);

  const auto run = kanexpr::simulate<System>({{q, 0.1}, {u, 0}}, {{l, 1}}, {0, 1},
                                             {.events = {kanexpr::when<System, q>("passes")}});
  const kanexpr::operating_point<System> rest({{q, 0.1}}, {{l, 1}});
  is_good = is_good && run && rest && run.trajectory[q].size() > 1;
  is_good = is_good && !kanexpr::write_page<picture>("no page", run.trajectory, {.empty_page = ""});

  auto model = kanexpr::derive<System>();
  auto linear = model.linearize({{q, 0}, {u, 0}});
  const auto simplified = kanexpr::symbolic::simplify(linear.explicit_form().A);
  is_good = is_good && kanexpr::symbolic::print(simplified) != kanexpr::symbolic::latex(simplified);
  return is_good ? 0 : 1;
}
