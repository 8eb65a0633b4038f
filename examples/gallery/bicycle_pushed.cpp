// A bicycle without a hand on its handlebars is pushed to the side.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>
#include <pictures/bicycle.hpp>

int main(int count, char** words) {
  using namespace bicycle;
  gallery::page page(
      count, words,
      {.title = "Bicycle that steers itself",
       .kind = "Vehicles",
       .see = "The bicycle is pushed to the side at 4.6 m/s, steers into the fall and rights itself. Nobody "
              "steers: between 4.3 and 6.0 m/s the benchmark bicycle is stable by itself.",
       .source = "Meijaard, Papadopoulos, Ruina & Schwab, Linearized dynamics equations for the balance and "
                 "steer of a bicycle, Proceedings of the Royal Society A 463 (2007), pages 1955-1982"});
  const auto run = simulate<BoundSystem>({{q1, 0}, {q2, 0}, {q5, 0}, {u2, 0.4}, {u3, 4.6 / 0.3}, {u5, 0}}, {},
                                         {0, 8}, {.relative_tolerance = 1e-9, .output_every = 0.02});
  page.expect_energy(run.trajectory, 1e-6);
  page.expect_constraints(run.trajectory, 1e-8);
  double at_first = 0;
  for (const double lean : run.trajectory[q2]) at_first = std::max(at_first, std::abs(lean));
  page.expect(at_first > 0.05 && std::abs(run.state[q2]) < 0.1 * at_first, "the bicycle rights itself");
  return page.show<bicycle::picture>(
      run, {.eye = Eigen::Vector3d(-0.4, -1, 0.35), .angles = false, .lengths = false, .names = false});
}
