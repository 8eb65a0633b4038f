#include "demo/compiled.hpp"
#include "demo/ride.hpp"
#include "demo/time_of.hpp"

#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/progress.hpp>

demo::compiled demo::compiled_bicycle() {
  using eom = kanexpr::equations_of_motion<bicycle::BoundSystem>;
  using namespace bicycle;
  eom::state x;
  x[q1] = -2.193815;
  x[q2] = 0.277947;
  x[q5] = 0.31653;
  x[u2] = -0.00913;
  x[u3] = 8.484732;
  x[u5] = 0.303186;
  kanexpr::assemble<BoundSystem>(x); // q4, u1, u4 and u6
  const Eigen::Vector<double, 6> reference{{0.5603933912016607, 0.18699750100126994, 1.8917584218369776,
                                            -0.9079710500366327, 0.02941699788325535, 1.0832124052217722}};
  return {eom::rhs(x).tail<6>(),
          reference,
          {{"all rates", eom::cost(eom::rhs)}},
          time_of(x, [&](const eom::state& at) { return eom::rhs(at); })};
}

// What depends on these by the constraints, the pitch and the spin of the front wheel, is solved for.
demo::ride demo::pushed_bicycle(double speed, double push, double seconds) {
  using namespace bicycle;
  constexpr double rear_radius = 0.3, too_far = 0.7; // m, rad
  return simulate<BoundSystem>({{q1, 0}, {q2, 0}, {q5, 0}, {u2, push}, {u3, speed / rear_radius}, {u5, 0}},
                               {}, {0, seconds},
                               {.output_every = 0.02,
                                .events = {when<BoundSystem, q2 * q2 - too_far * too_far>(
                                    "it falls", crossing::rising, after_event::stop)},
                                .progress = progress_bar(stdout)});
}
