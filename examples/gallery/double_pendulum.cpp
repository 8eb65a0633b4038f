// Two bars fall from almost upright; a second run that begins a millionth of a radian away soon differs.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>
#include <pictures/double_pendulum.hpp>

int main(int count, char** words) {
  using namespace double_pendulum;
  gallery::page page(
      count, words,
      {.title = "Double pendulum",
       .kind = "Pendulums",
       .see = "The second bar swings, turns over and comes back without any pattern. A start that "
              "differs by a millionth of a radian leads to a different motion within fifteen seconds, "
              "which is what chaos means.",
       .source = "Shinbrot, Grebogi, Wisdom & Yorke, Chaos in a double pendulum, American Journal of "
                 "Physics 60 (1992), pages 491-499"});
  const given_parameters<System> bars{{m1, 1},        {m2, 1},        {d1, 0.5}, {d2, 0.5}, {l1, 1},
                                      {I1, 1 / 12.0}, {I2, 1 / 12.0}, {g, 9.81}, {c1, 0},   {c2, 0}};
  const auto run_from = [&](double angle) {
    return simulate<System>(
        {{q1, angle}, {q2, 0.4}, {u1, 0}, {u2, 0}}, bars, {0, 15},
        {.inputs = {{T1, 0}, {T2, 0}}, .relative_tolerance = 1e-12, .output_every = 0.02});
  };
  const auto run = run_from(1.3), other = run_from(1.3 + 1e-6);
  page.expect_energy(run.trajectory, 1e-8);
  page.expect(std::abs(run.state[q2] - other.state[q2]) > 0.1,
              "a start that differs by 1e-6 rad leads to a different motion");
  return page.show<double_pendulum::picture>(run, {.at = 0.5});
}
